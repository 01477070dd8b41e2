#pragma once

#include "client/model/workspace/workspace.h"

namespace burnish {

/// Draws what is known of the raw scan while the server prepares it, and the choice of its depth.
/// Needs: a raw scan.
void draw_raw_facts(Workspace& workspace);

}  // namespace burnish

#pragma once

#include "client/model/workspace/workspace.h"

namespace burnish {

/// Draws the list of what the brush can paint: β, the strength of kept edges, the gain of a band, a
/// curve of the palette, the colours.
void draw_painted_choice(Workspace& workspace);

}  // namespace burnish

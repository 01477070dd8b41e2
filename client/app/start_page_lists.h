#pragma once

#include "client/model/workspace.h"

namespace burnish {

/// The server's scans; a click opens one in a session of its own.
void draw_scans(Workspace& workspace);

/// Its sessions; a click joins one.
void draw_sessions(Workspace& workspace);

}  // namespace burnish

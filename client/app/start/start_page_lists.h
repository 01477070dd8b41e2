#pragma once

#include "client/model/workspace/workspace.h"

namespace burnish {

/// Lists the server's scans; a click opens one in a new session.
void draw_scans(Workspace& workspace);

/// Lists the server's sessions; a click joins one.
void draw_sessions(Workspace& workspace);

}  // namespace burnish

#pragma once

#include "client/model/leaving.h"
#include "client/model/workspace.h"

namespace burnish {

/// Asks what becomes of edits that are not saved, while `step` is kAsk or kWait. Between ImGui's
/// begin and end of a picture.
void draw_leave_question(const Workspace& workspace, Leaving::Step step, Leaving& leaving);

}  // namespace burnish

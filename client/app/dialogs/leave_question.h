#pragma once

#include "client/model/workspace/leaving.h"
#include "client/model/workspace/workspace.h"

namespace burnish {

/// Asks what to do with what is not saved while `step` is kAsk or kWait. Needs: a call between
/// ImGui's begin and end of a picture.
void draw_leave_question(const Workspace& workspace, Leaving::Step step, Leaving& leaving);

}  // namespace burnish

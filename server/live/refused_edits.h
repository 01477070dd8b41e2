#pragma once

#include "common/service/live.h"

namespace burnish {

/// Counts a refusal of a client's edits among the refusals if a limit or a role is why, and logs
/// one of each kind a minute. An ordinary call's end does the same; a live stream goes on.
void report_refused_edits(const EditsRefused& refused);

}  // namespace burnish

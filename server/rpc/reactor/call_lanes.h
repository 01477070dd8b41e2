#pragma once

#include <string_view>

#include "server/scheduling/lanes.h"

namespace burnish {

/// Returns the lane of an RPC's work, e.g. for "/burnish.v1.Library/ListScans".
Lane lane_of(std::string_view method);

}  // namespace burnish

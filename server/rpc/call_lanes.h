#pragma once

#include <string_view>

#include "server/scheduling/lanes.h"

namespace burnish {

/// Where an RPC's work runs, e.g. that of "/burnish.v1.Library/ListScans".
Lane lane_of(std::string_view method);

}  // namespace burnish

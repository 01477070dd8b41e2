#pragma once

#include <string_view>

#include "server/scheduling/pools.h"

namespace burnish {

/// Returns the pool of an RPC's work, e.g. for "/burnish.v1.Library/ListScans".
Pool pool_of(std::string_view method);

}  // namespace burnish

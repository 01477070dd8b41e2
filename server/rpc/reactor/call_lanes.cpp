#include "server/rpc/reactor/call_lanes.h"

#include <utility>

namespace burnish {

// A call that is not listed waits for a session, as most calls do.
static constexpr std::pair<std::string_view, Lane> kLanes[] = {
    {"/burnish.v1.Library/ListScans", Lane::kShort},
    {"/burnish.v1.Library/DescribeScan", Lane::kShort},
    {"/burnish.v1.Library/FetchPages", Lane::kShort},
    {"/burnish.v1.Library/FetchSheets", Lane::kShort},
    {"/burnish.v1.Editing/ListSessions", Lane::kShort},

    {"/burnish.v1.Library/PrepareScan", Lane::kLong},
    {"/burnish.v1.Library/DescribePages", Lane::kLong},
    {"/burnish.v1.Library/DescribeSheets", Lane::kLong},
    {"/burnish.v1.Library/ProposeEdges", Lane::kLong},
    {"/burnish.v1.Editing/OpenSession", Lane::kLong},
    {"/burnish.v1.Editing/ForkSession", Lane::kLong},
    {"/burnish.v1.Editing/Export", Lane::kLong},
};

Lane lane_of(std::string_view method) {
  for (const auto& [known, lane] : kLanes)
    if (known == method) return lane;
  return Lane::kSession;
}

}  // namespace burnish

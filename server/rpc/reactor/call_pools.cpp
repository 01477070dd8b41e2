#include "server/rpc/reactor/call_pools.h"

#include <utility>

namespace burnish {

// A call that is not listed waits for a session, as most calls do.
static constexpr std::pair<std::string_view, Pool> kPools[] = {
    {"/burnish.v1.Library/ListScans", Pool::kShort},
    {"/burnish.v1.Library/DescribeScan", Pool::kShort},
    {"/burnish.v1.Library/FetchPages", Pool::kShort},
    {"/burnish.v1.Library/FetchSheets", Pool::kShort},
    {"/burnish.v1.Editing/ListSessions", Pool::kShort},

    {"/burnish.v1.Library/PrepareScan", Pool::kLong},
    {"/burnish.v1.Library/DescribePages", Pool::kLong},
    {"/burnish.v1.Library/DescribeSheets", Pool::kLong},
    {"/burnish.v1.Library/ProposeEdges", Pool::kLong},
    {"/burnish.v1.Editing/OpenSession", Pool::kLong},
    {"/burnish.v1.Editing/ForkSession", Pool::kLong},
    {"/burnish.v1.Editing/Export", Pool::kLong},
};

Pool pool_of(std::string_view method) {
  for (const auto& [known, pool] : kPools)
    if (known == method) return pool;
  return Pool::kSession;
}

}  // namespace burnish

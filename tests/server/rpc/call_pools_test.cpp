#include "server/rpc/reactor/call_pools.h"

#include <gtest/gtest.h>

#include "server/trust/role.h"

namespace burnish {
namespace {

TEST(CallPools, ListsAreShortAndWhatComputesIsLong) {
  for (const char* method : {"/burnish.v1.Library/ListScans", "/burnish.v1.Editing/ListSessions",
                             "/burnish.v1.Library/DescribeScan", "/burnish.v1.Library/FetchPages",
                             "/burnish.v1.Library/FetchSheets"})
    EXPECT_EQ(pool_of(method), Pool::kShort) << method;
  for (const char* method :
       {"/burnish.v1.Library/DescribePages", "/burnish.v1.Library/PrepareScan",
        "/burnish.v1.Library/DescribeSheets", "/burnish.v1.Library/ProposeEdges",
        "/burnish.v1.Editing/Export", "/burnish.v1.Editing/OpenSession",
        "/burnish.v1.Editing/ForkSession"}) {
    EXPECT_EQ(pool_of(method), Pool::kLong) << method;
    EXPECT_TRUE(least_role(method)) << method;
  }
  EXPECT_EQ(pool_of("/burnish.v1.Editing/Apply"), Pool::kSession);
}

}  // namespace
}  // namespace burnish

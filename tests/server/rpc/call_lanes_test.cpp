#include "server/rpc/call_lanes.h"

#include <future>

#include <gtest/gtest.h>

#include "server/trust/role.h"

namespace burnish {
namespace {

TEST(CallLanes, ListsAreShortAndWhatComputesIsLong) {
  for (const char* method : {"/burnish.v1.Library/ListScans", "/burnish.v1.Editing/ListSessions",
                             "/burnish.v1.Library/DescribeScan"})
    EXPECT_EQ(lane_of(method), Lane::kShort) << method;
  for (const char* method : {"/burnish.v1.Library/FetchView", "/burnish.v1.Library/PrepareScan",
                             "/burnish.v1.Editing/Export", "/burnish.v1.Editing/OpenSession",
                             "/burnish.v1.Editing/ForkSession"}) {
    EXPECT_EQ(lane_of(method), Lane::kLong) << method;
    EXPECT_TRUE(least_role(method)) << method;
  }
  EXPECT_EQ(lane_of("/burnish.v1.Editing/Apply"), Lane::kSession);
}

TEST(Lanes, WorkThatFillsALaneHoldsUpNoOther) {
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  Lanes lanes({.workers = 2, .workers_per_user = 2});
  for (const Lane full : {Lane::kLong, Lane::kSession})
    for (int i = 0; i < 60; ++i) lanes[full].post({[ended] { ended.wait(); }, {}, "user vera"});
  std::promise<void> listed;
  lanes[Lane::kShort].post({[&] { listed.set_value(); }, {}, "user anna"});
  listed.get_future().wait();
  end.set_value();
}

}  // namespace
}  // namespace burnish

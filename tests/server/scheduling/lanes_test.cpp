#include "server/scheduling/lanes.h"

#include <future>

#include <gtest/gtest.h>

namespace burnish {
namespace {

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

#include "server/scheduling/pools.h"

#include <future>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Pools, WorkThatFillsAPoolHoldsUpNoOther) {
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  Pools pools({.workers = 2, .workers_per_user = 2});
  for (const Pool full : {Pool::kLong, Pool::kSession})
    for (int i = 0; i < 60; ++i) pools[full].post({[ended] { ended.wait(); }, {}, "user vera"});
  std::promise<void> listed;
  pools[Pool::kShort].post({[&] { listed.set_value(); }, {}, "user anna"});
  listed.get_future().wait();
  end.set_value();
}

}  // namespace
}  // namespace burnish

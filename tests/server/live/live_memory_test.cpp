// The memory of a live session and its clients, and when they give it back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/memory/memory_need.h"
#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using LiveMemory = LiveWork;

TEST_F(LiveMemory, PagesCountOnceForAllClientsAndFramesForEach) {
  { auto first = guest(); }  // opens the page file
  Quota& memory = manager_->memory();
  const uint64_t before = memory.taken();
  {
    auto ann = guest(), bob = guest("bob");
    ann.show_level(0);
    ann.run();
    const uint64_t with_ann = memory.taken();
    const uint64_t of_a_client = predict_client_bytes(ann.subscriber().pages()->shown.pages());
    EXPECT_GT(with_ann, before + of_a_client);
    bob.show_level(0);
    bob.run();
    EXPECT_EQ(memory.taken(), with_ann + of_a_client - predict_client_bytes({}));
  }
  EXPECT_EQ(memory.taken(), before);
}

TEST_F(LiveMemory, PagesThatDoNotFitEndTheStreamAndSayWhy) {
  auto ann = guest(), bob = guest("bob");
  Quota& memory = manager_->memory();
  const Quota::Share rest = memory.take(kServer, memory.max() - memory.taken() - 10'000).value();
  ann.show_level(0);
  ann.run();
  const auto go_aways = ann.all<GoAway>();
  ASSERT_EQ(go_aways.size(), 1u);
  EXPECT_THAT(go_aways[0].reason, testing::ContainsRegex("needs [0-9]+ more"));
  EXPECT_EQ(go_aways[0].code, GoAwayCode::kTooManyPages);
  EXPECT_TRUE(go_aways[0].come_back);
  bob.settle();
  EXPECT_FALSE(bob.finished);
}

TEST_F(LiveMemory, WhoDoesNotFitIsNotLetIn) {
  auto ann = guest();
  Quota& memory = manager_->memory();
  const uint64_t of_a_client = predict_client_bytes({});
  const uint64_t taken = memory.taken(), left = of_a_client - 1;
  Quota::Share rest = memory.take(kServer, memory.max() - taken - left).value();
  const Status refused = live_->join({"work"}, "bob", {}, {}).status();
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
  EXPECT_EQ(refused.message(),
            "frames for a client of session work: the server has " +
                std::to_string(memory.max() - left) + " bytes of meshes and sessions and needs " +
                std::to_string(of_a_client) + " more; limits.memory_bytes_max is " +
                std::to_string(memory.max()));
  rest = {};
  EXPECT_TRUE(manager_->presence("work").value()->list().size() == 1);
  const auto bob = guest("bob");
  EXPECT_EQ(memory.taken(), taken + of_a_client);
}

TEST_F(LiveMemory, ASessionsBytesAreWithThoseOfItsClientsFrames) {
  const auto bytes = [this] { return manager_->state("work", {}).value().memory_bytes; };
  auto ann = guest();
  ann.show_level(0);
  ann.edit({{"a", SetTransferCurve{TransferCurve(5)}}, {"b", SetGradientScale{0}}});
  ann.settle();
  const uint64_t with_one = bytes();
  {
    auto bob = guest("bob");
    bob.show_level(0);
    bob.settle();
    EXPECT_EQ(bytes(), with_one + bob.subscriber().byte_count());
    EXPECT_EQ(live_->usage().client_bytes,
              ann.subscriber().byte_count() + bob.subscriber().byte_count());
    EXPECT_GT(bob.subscriber().byte_count(), 2 * bob.pages.values().size());
  }
  EXPECT_EQ(bytes(), with_one);
}

TEST_F(LiveMemory, AClosedSessionStaysOutOfMemoryWhileItsClientsGo) {
  auto ann = guest(), bob = guest("bob");
  ann.edit({{"a", SetGradientScale{0}}});
  bob.run();
  ASSERT_TRUE(manager_->close("work", "ann", {}).is_ok());
  ann.leave();
  bob.run();
  EXPECT_TRUE(bob.finished);
  EXPECT_FALSE(manager_->list()[0].in_memory);
}

TEST_F(LiveMemory, UnusedSessionsLeaveMemoryAndComeBackAsTheyWere) {
  {
    auto ann = guest();
    ann.edit({{"a", stroke()}});
    ann.run();
    manager_->spill_idle(std::chrono::seconds(0));
    EXPECT_TRUE(manager_->list()[0].in_memory);  // a client is in it
  }
  manager_->spill_idle(std::chrono::seconds(1000));
  EXPECT_TRUE(manager_->list()[0].in_memory);
  manager_->spill_idle(std::chrono::seconds(0));
  EXPECT_FALSE(manager_->list()[0].in_memory);
  EXPECT_EQ(manager_->usage().session_bytes, 0u);
  auto ann = guest();
  ann.show_level(0);
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.edits, 1u);
  EXPECT_EQ(ann.pages.values(), sample(ann));
}

}  // namespace
}  // namespace burnish

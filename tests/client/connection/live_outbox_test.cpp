#include "client/connection/live_outbox.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

const LiveOutbox::Time kNow{};

std::vector<Edit> slider(const std::string& id) {
  return {Edit{id, SetGradientScale{0.5}}};
}

Stroke stroke(std::vector<Vec3d> path) {
  return {{.radius = 1, .strength = 1, .beta = 2}, std::move(path)};
}

/// Returns an outbox that has sent its greeting.
LiveOutbox greeted() {
  LiveOutbox outbox{v1::Greeting()};
  EXPECT_TRUE(outbox.next()->has_greeting());
  return outbox;
}

TEST(LiveOutbox, SaysItsGreetingFirstAndOnce) {
  LiveOutbox outbox = greeted();
  EXPECT_FALSE(outbox.next());
  outbox.restart();
  EXPECT_TRUE(outbox.next()->has_greeting());
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, SaysEditsOnceForEachStreamUntilTheyAreAnswered) {
  LiveOutbox outbox = greeted();
  outbox.apply(slider("a"), kNow);
  outbox.apply(slider("b"), kNow);
  EXPECT_EQ(outbox.next()->apply().edits(0).id(), "a");
  EXPECT_EQ(outbox.next()->apply().edits(0).id(), "b");
  EXPECT_FALSE(outbox.next());
  EXPECT_EQ(outbox.unacknowledged(), 2u);
  EXPECT_TRUE(outbox.answered("a"));
  EXPECT_FALSE(outbox.answered("a"));
  outbox.restart();
  EXPECT_TRUE(outbox.next()->has_greeting());
  EXPECT_EQ(outbox.next()->apply().edits(0).id(), "b");
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, MergesPreviewsThatWait) {
  LiveOutbox outbox = greeted();
  for (const double beta : {0.1, 0.2, 0.3}) outbox.preview("a", SetGradientScale{beta}, kNow);
  EXPECT_EQ(outbox.next()->preview().gradient_scale().beta(), 0.3);
  EXPECT_FALSE(outbox.next());
  outbox.preview("b", stroke({Vec3d(0, 0, 0)}), kNow);
  outbox.preview("b", stroke({Vec3d(1, 0, 0)}), kNow);
  EXPECT_EQ(outbox.next()->preview().stroke().path_size(), 2);
  EXPECT_EQ(outbox.previews_sent(), 2u);
}

TEST(LiveOutbox, SaysOnlyTheNewPartOfAStroke) {
  LiveOutbox outbox = greeted();
  outbox.preview("s", stroke({Vec3d(0, 0, 0)}), kNow);
  ASSERT_TRUE(outbox.next());
  outbox.preview("s", stroke({Vec3d(1, 0, 0), Vec3d(2, 0, 0)}), kNow);
  const auto message = outbox.next();
  EXPECT_EQ(message->preview().edit_id(), "s");
  EXPECT_EQ(message->preview().stroke().brush().radius(), 1);
  ASSERT_EQ(message->preview().stroke().path_size(), 2);
  EXPECT_EQ(message->preview().stroke().path(0).x(), 1);
}

TEST(LiveOutbox, EndsAPreviewWithItsEdit) {
  LiveOutbox outbox = greeted();
  outbox.preview("a", SetGradientScale{0.1}, kNow);
  outbox.apply(slider("a"), kNow);
  EXPECT_TRUE(outbox.next()->has_apply());
  EXPECT_FALSE(outbox.next());
  outbox.drop_preview("a");
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, DropsThePreviewThatIsOnAndNoOther) {
  LiveOutbox outbox = greeted();
  outbox.preview("a", SetGradientScale{0.1}, kNow);
  ASSERT_TRUE(outbox.next());
  outbox.drop_preview("b");
  EXPECT_FALSE(outbox.next());
  outbox.drop_preview("a");
  EXPECT_TRUE(outbox.next()->preview().has_drop());
  outbox.restart();
  EXPECT_TRUE(outbox.next()->has_greeting());
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, DoesNotSayARefusedPreviewAgain) {
  LiveOutbox outbox = greeted();
  outbox.preview("a", SetGradientScale{0.1}, kNow);
  EXPECT_TRUE(outbox.forget_preview("a"));
  outbox.restart();
  ASSERT_TRUE(outbox.next()->has_greeting());
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, SaysTheNewestRing) {
  LiveOutbox outbox = greeted();
  outbox.move_brush(BrushRing{Vec3d(1, 0, 0), 2});
  outbox.move_brush(BrushRing{Vec3d(2, 0, 0), 2});
  EXPECT_EQ(outbox.next()->move_brush().ring().centre().x(), 2);
  outbox.move_brush(BrushRing{Vec3d(2, 0, 0), 2});
  EXPECT_FALSE(outbox.next());
  outbox.restart();
  ASSERT_TRUE(outbox.next()->has_greeting());
  EXPECT_TRUE(outbox.next()->move_brush().has_ring());
}

}  // namespace
}  // namespace burnish

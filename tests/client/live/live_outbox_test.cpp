#include "client/live/live_outbox.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

const LiveOutbox::Time kNow{};
constexpr uint32_t kPages = 10;

std::vector<Edit> slider(const std::string& id) {
  return {Edit{id, SetGradientScale{0.5}}};
}

Stroke stroke(std::vector<Vec3d> path) {
  return {{.radius = 1, .strength = 1, .beta = 2}, std::move(path)};
}

template <typename Message>
bool says(const std::optional<ClientMessage>& message) {
  return message && std::holds_alternative<Message>(*message);
}

/// Returns the next message, which must be of this kind.
template <typename Message>
Message next(LiveOutbox& outbox) {
  return std::get<Message>(outbox.next().value());
}

std::string next_edit(LiveOutbox& outbox) {
  return next<ApplyEdits>(outbox).edits.at(0).id;
}

/// Returns an outbox that has sent its greeting.
LiveOutbox greeted() {
  LiveOutbox outbox(Greeting(), kPages);
  EXPECT_TRUE(says<Greeting>(outbox.next()));
  return outbox;
}

TEST(LiveOutbox, SaysItsGreetingFirstAndOnce) {
  LiveOutbox outbox = greeted();
  EXPECT_FALSE(outbox.next());
  outbox.restart();
  EXPECT_TRUE(says<Greeting>(outbox.next()));
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, SaysThePagesRightAfterItsGreeting) {
  LiveOutbox outbox(Greeting(), kPages);
  outbox.apply(slider("a"), kNow);
  outbox.move_brush(BrushRing{});
  auto page = std::make_shared<Page>();
  page->id = 3;
  ASSERT_TRUE(outbox.pages().change({std::move(page)}, {}).is_ok());
  for (int stream = 0; stream < 2; ++stream) {
    EXPECT_TRUE(says<Greeting>(outbox.next()));
    const auto change = next<ShowPages>(outbox);
    EXPECT_EQ(change.revision, 1u);
    EXPECT_EQ(change.added, std::vector<PageId>{3});
    EXPECT_TRUE(says<ApplyEdits>(outbox.next()));
    outbox.restart();
  }
}

TEST(LiveOutbox, SaysEditsOnceForEachStreamUntilTheyAreAnswered) {
  LiveOutbox outbox = greeted();
  outbox.apply(slider("a"), kNow);
  outbox.apply(slider("b"), kNow);
  EXPECT_EQ(next_edit(outbox), "a");
  EXPECT_EQ(next_edit(outbox), "b");
  EXPECT_FALSE(outbox.next());
  EXPECT_EQ(outbox.unacknowledged(), 2u);
  EXPECT_TRUE(outbox.answered("a"));
  EXPECT_FALSE(outbox.answered("a"));
  outbox.restart();
  EXPECT_TRUE(says<Greeting>(outbox.next()));
  EXPECT_EQ(next_edit(outbox), "b");
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, MergesPreviewsThatWait) {
  LiveOutbox outbox = greeted();
  for (const double beta : {0.1, 0.2, 0.3}) outbox.preview("a", SetGradientScale{beta}, kNow);
  EXPECT_EQ(std::get<SetGradientScale>(next<Preview>(outbox).change).beta, 0.3);
  EXPECT_FALSE(outbox.next());
  outbox.preview("b", stroke({Vec3d(0, 0, 0)}), kNow);
  outbox.preview("b", stroke({Vec3d(1, 0, 0)}), kNow);
  EXPECT_EQ(std::get<Stroke>(next<Preview>(outbox).change).path.size(), 2u);
  EXPECT_EQ(outbox.previews_sent(), 2u);
}

TEST(LiveOutbox, SaysOnlyTheNewPartOfAStroke) {
  LiveOutbox outbox = greeted();
  outbox.preview("s", stroke({Vec3d(0, 0, 0)}), kNow);
  ASSERT_TRUE(outbox.next());
  outbox.preview("s", stroke({Vec3d(1, 0, 0), Vec3d(2, 0, 0)}), kNow);
  const auto part = next<Preview>(outbox);
  EXPECT_EQ(part.edit_id, "s");
  const auto& said = std::get<Stroke>(part.change);
  EXPECT_EQ(said.brush.radius, 1);
  ASSERT_EQ(said.path.size(), 2u);
  EXPECT_EQ(said.path[0].x(), 1);
}

TEST(LiveOutbox, EndsAPreviewWithItsEdit) {
  LiveOutbox outbox = greeted();
  outbox.preview("a", SetGradientScale{0.1}, kNow);
  outbox.apply(slider("a"), kNow);
  EXPECT_TRUE(says<ApplyEdits>(outbox.next()));
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
  EXPECT_TRUE(says<DropPreview>(outbox.next()));
  outbox.restart();
  EXPECT_TRUE(says<Greeting>(outbox.next()));
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, APreviewOfWhichNothingWasSaidEndsUnsaid) {
  LiveOutbox outbox = greeted();
  outbox.preview("a", SetGradientScale{0.1}, kNow);
  outbox.drop_preview("a");
  EXPECT_TRUE(outbox.has_said_previews());
  EXPECT_FALSE(outbox.next());
  EXPECT_EQ(outbox.previews_sent(), 0u);
}

TEST(LiveOutbox, DropsAPreviewWhoseNewestValueIsUnsaid) {
  LiveOutbox outbox = greeted();
  outbox.preview("a", SetGradientScale{0.1}, kNow);
  ASSERT_TRUE(says<Preview>(outbox.next()));
  outbox.preview("a", SetGradientScale{0.2}, kNow);
  outbox.drop_preview("a");
  EXPECT_FALSE(outbox.has_said_previews());
  EXPECT_TRUE(says<DropPreview>(outbox.next()));
  EXPECT_TRUE(outbox.has_said_previews());
  EXPECT_FALSE(outbox.next());
}

// The server has the first preview until it hears of its end, or of another preview.
TEST(LiveOutbox, APreviewThatEndsUnsaidLeavesTheEndOfTheOneBefore) {
  for (const bool is_edit : {false, true}) {
    LiveOutbox outbox = greeted();
    outbox.preview("a", SetGradientScale{0.1}, kNow);
    ASSERT_TRUE(says<Preview>(outbox.next()));
    outbox.drop_preview("a");
    outbox.preview("b", SetGradientScale{0.2}, kNow);
    is_edit ? outbox.apply(slider("b"), kNow) : outbox.drop_preview("b");
    if (is_edit) {
      EXPECT_TRUE(says<ApplyEdits>(outbox.next()));
    }
    EXPECT_EQ(next<DropPreview>(outbox).edit_id, "a");
    EXPECT_FALSE(outbox.next());
  }
}

TEST(LiveOutbox, DoesNotSayARefusedPreviewAgain) {
  LiveOutbox outbox = greeted();
  outbox.preview("a", SetGradientScale{0.1}, kNow);
  EXPECT_TRUE(outbox.forget_preview("a"));
  outbox.restart();
  ASSERT_TRUE(says<Greeting>(outbox.next()));
  EXPECT_FALSE(outbox.next());
}

TEST(LiveOutbox, SaysTheNewestRing) {
  LiveOutbox outbox = greeted();
  outbox.move_brush(BrushRing{Vec3d(1, 0, 0), 2});
  outbox.move_brush(BrushRing{Vec3d(2, 0, 0), 2});
  EXPECT_EQ(next<MoveBrush>(outbox).ring->centre.x(), 2);
  outbox.move_brush(BrushRing{Vec3d(2, 0, 0), 2});
  EXPECT_FALSE(outbox.next());
  outbox.restart();
  ASSERT_TRUE(says<Greeting>(outbox.next()));
  EXPECT_TRUE(next<MoveBrush>(outbox).ring.has_value());
}

}  // namespace
}  // namespace burnish

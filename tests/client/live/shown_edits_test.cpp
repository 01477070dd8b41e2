#include "client/live/shown_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

ShownEdits::Time at(int ms) {
  return ShownEdits::Time(std::chrono::hours(1)) + milliseconds(ms);
}

TEST(ShownEdits, AreShownByTheFirstFrameThatHasThem) {
  ShownEdits shown;
  shown.acknowledged({"a"}, at(0), 5);
  shown.frame(4, 0, at(10));
  EXPECT_TRUE(shown.take_edits().empty());
  shown.frame(6, 0, at(30));
  const auto edits = shown.take_edits();
  ASSERT_EQ(edits.size(), 1u);
  EXPECT_THAT(edits[0].edit_ids, ElementsAre("a"));
  EXPECT_EQ(edits[0].latency_ms, 30);
  EXPECT_TRUE(shown.take_edits().empty());
}

TEST(ShownEdits, MayBeShownBeforeTheyAreAcknowledged) {
  ShownEdits shown;
  shown.frame(4, 0, at(10));
  shown.frame(5, 0, at(20));
  shown.frame(5, 0, at(30));
  shown.acknowledged({"a"}, at(12), 5);
  const auto edits = shown.take_edits();
  ASSERT_EQ(edits.size(), 1u);
  EXPECT_EQ(edits[0].latency_ms, 8);
}

TEST(ShownEdits, AFrameOfAnEarlierStreamMayShowItsPreviews) {
  ShownEdits shown;
  shown.restart();
  EXPECT_TRUE(shown.shows_previews()) << "nothing was previewed";
  shown.preview_sent(1, at(0));
  shown.frame(0, 1, at(5));
  EXPECT_TRUE(shown.shows_previews());
  shown.restart();
  EXPECT_FALSE(shown.shows_previews());
  shown.frame(0, 0, at(20));
  EXPECT_TRUE(shown.shows_previews());
}

TEST(ShownEdits, PreviewsAreCountedByStream) {
  ShownEdits shown;
  shown.preview_sent(1, at(0));
  shown.preview_sent(2, at(5));
  shown.frame(0, 1, at(20));
  EXPECT_THAT(shown.take_previews(), ElementsAre(20));
  shown.restart();
  shown.preview_sent(1, at(30));
  shown.frame(0, 1, at(31));
  EXPECT_THAT(shown.take_previews(), ElementsAre(1));
}

}  // namespace
}  // namespace burnish

#include "server/live/client_pages.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using enum PageFrameKind;

TEST(ChooseKind, AFreeChoiceTakesTheCheaperOne) {
  EXPECT_EQ(choose_kind({}, 1000, 700), kCorners);
  EXPECT_EQ(choose_kind({}, 1000, 750), kVertices);
}

TEST(ChooseKind, ChangesOnlyForAThirdOfTheBytes) {
  EXPECT_EQ(choose_kind(kVertices, 1000, 700), kVertices);
  EXPECT_EQ(choose_kind(kVertices, 1000, 490), kCorners);
  EXPECT_EQ(choose_kind(kCorners, 1000, 750), kCorners);
  EXPECT_EQ(choose_kind(kCorners, 1000, 1100), kVertices);
}

}  // namespace
}  // namespace burnish

#include "client/model/workspace/leaving.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;
using Step = Leaving::Step;

constexpr Leaving::Time kStart;
constexpr auto kSoon = kStart + milliseconds(100), kLater = kStart + milliseconds(5000);

TEST(Leaving, WithoutUnsavedEditsIsAtOnce) {
  Leaving leaving;
  EXPECT_EQ(leaving.update(0, true, kStart), Step::kStay);
  leaving.begin(Leaving::What::kSession, kStart);
  EXPECT_EQ(leaving.update(0, false, kStart), Step::kLeave);
  EXPECT_EQ(leaving.what(), Leaving::What::kSession);
}

TEST(Leaving, GivesAServerThatAnswersAMomentAndThenAsks) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  EXPECT_EQ(leaving.update(2, true, kSoon), Step::kSave);
  EXPECT_EQ(leaving.update(2, true, kLater), Step::kAsk);
  EXPECT_EQ(leaving.update(0, true, kLater), Step::kLeave);
}

TEST(Leaving, AsksAtOnceWhereTheServerIsGone) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  EXPECT_EQ(leaving.update(1, false, kStart), Step::kAsk);
  EXPECT_EQ(leaving.update(1, true, kSoon), Step::kAsk);  // the question does not come and go
}

TEST(Leaving, WhoWaitsLeavesWhenAllIsSaved) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  ASSERT_EQ(leaving.update(1, false, kStart), Step::kAsk);
  leaving.wait();
  EXPECT_EQ(leaving.update(1, false, kLater), Step::kWait);
  EXPECT_EQ(leaving.update(0, true, kLater), Step::kLeave);
}

TEST(Leaving, WhoDiscardsLeavesAndWhoStaysStays) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  leaving.discard();
  EXPECT_EQ(leaving.update(1, false, kStart), Step::kLeave);
  leaving.stay();
  EXPECT_EQ(leaving.update(1, false, kLater), Step::kStay);
  leaving.begin(Leaving::What::kSession, kLater);
  EXPECT_EQ(leaving.update(1, true, kLater), Step::kSave);
}

TEST(Leaving, TheMomentIsNotGivenAnewWhenItIsSaidAgain) {
  Leaving leaving;
  leaving.begin(Leaving::What::kSession, kStart);
  leaving.begin(Leaving::What::kWindow, kLater);
  EXPECT_EQ(leaving.update(1, true, kLater), Step::kAsk);
  EXPECT_EQ(leaving.what(), Leaving::What::kWindow);
}

}  // namespace
}  // namespace burnish

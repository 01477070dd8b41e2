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
  EXPECT_EQ(leaving.update({.edits = 0}, true, kStart), Step::kStay);
  leaving.begin(Leaving::What::kSession, kStart);
  EXPECT_EQ(leaving.update({.edits = 0}, false, kStart), Step::kLeave);
  EXPECT_EQ(leaving.what(), Leaving::What::kSession);
}

TEST(Leaving, GivesAServerThatAnswersAMomentAndThenAsks) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  EXPECT_EQ(leaving.update({.edits = 2}, true, kSoon), Step::kSave);
  EXPECT_EQ(leaving.update({.edits = 2}, true, kLater), Step::kAsk);
  EXPECT_EQ(leaving.update({.edits = 0}, true, kLater), Step::kLeave);
}

TEST(Leaving, AsksAtOnceWhereTheServerIsGone) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  EXPECT_EQ(leaving.update({.edits = 1}, false, kStart), Step::kAsk);
  EXPECT_EQ(leaving.update({.edits = 1}, true, kSoon),
            Step::kAsk);  // the question does not come and go
}

TEST(Leaving, WhoWaitsLeavesWhenAllIsSaved) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  ASSERT_EQ(leaving.update({.edits = 1}, false, kStart), Step::kAsk);
  leaving.wait();
  EXPECT_EQ(leaving.update({.edits = 1}, false, kLater), Step::kWait);
  EXPECT_EQ(leaving.update({.edits = 0}, true, kLater), Step::kLeave);
}

TEST(Leaving, WhoDiscardsLeavesAndWhoStaysStays) {
  Leaving leaving;
  leaving.begin(Leaving::What::kWindow, kStart);
  leaving.discard();
  EXPECT_EQ(leaving.update({.edits = 1}, false, kStart), Step::kLeave);
  leaving.stay();
  EXPECT_EQ(leaving.update({.edits = 1}, false, kLater), Step::kStay);
  leaving.begin(Leaving::What::kSession, kLater);
  EXPECT_EQ(leaving.update({.edits = 1}, true, kLater), Step::kSave);
}

TEST(Leaving, TheWindowWaitsForFilesAndASessionDoesNot) {
  const Unsaved writing{.files = 1};
  Leaving leaving;
  leaving.begin(Leaving::What::kSession, kStart);
  EXPECT_EQ(leaving.update(writing, true, kStart), Step::kLeave);
  leaving.begin(Leaving::What::kWindow, kStart);
  EXPECT_EQ(leaving.update(writing, true, kSoon), Step::kSave);
  EXPECT_EQ(leaving.update(writing, true, kLater), Step::kAsk);
  EXPECT_EQ(leaving.update({}, true, kLater), Step::kLeave);
}

TEST(Unsaved, IsToldInWords) {
  EXPECT_EQ(text_of({.edits = 1}), "1 edit is not saved");
  EXPECT_EQ(text_of({.edits = 3, .files = 1}), "3 edits are not saved, 1 file is not written");
  EXPECT_EQ(text_of({.files = 2}), "2 files are not written");
}

TEST(Leaving, TheMomentIsNotGivenAnewWhenItIsSaidAgain) {
  Leaving leaving;
  leaving.begin(Leaving::What::kSession, kStart);
  leaving.begin(Leaving::What::kWindow, kLater);
  EXPECT_EQ(leaving.update({.edits = 1}, true, kLater), Step::kAsk);
  EXPECT_EQ(leaving.what(), Leaving::What::kWindow);
}

}  // namespace
}  // namespace burnish

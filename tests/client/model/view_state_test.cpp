#include "client/model/view/view_state.h"

#include <fstream>

#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

ViewState some_view() {
  ViewState view;
  view.scan = "5ca4";
  view.camera.target = Vec3d(4.5e5, -2, 0.1);
  view.camera.distance = 7.25;
  view.camera.azimuth_degrees = -33;
  view.camera.elevation_degrees = 12;
  view.camera.up = UpAxis::kMinusZ;
  view.camera.orthographic = true;
  view.options.split = true;
  view.options.split_at = 0.25;
  view.options.displacement = {0.5, 3};
  view.options.curvature = {0.25, 2};
  view.options.scale_bar = false;
  view.options.axes = false;
  view.options.lighting = {.kind = LightKind::kCavity, .azimuth_degrees = 10, .occlusion = 0.5};
  view.colour = ColourBy::kCurvature;
  view.bookmarks = {Camera{}, view.camera};
  return view;
}

TEST(ViewState, WhatIsWrittenIsReadAgainForItsSessionAlone) {
  const TemporaryFolder folder;
  const auto file = folder / "below/views.toml";
  ASSERT_TRUE(write_view(file, {"host:1", "abc"}, some_view()).is_ok());
  EXPECT_EQ(read_view(file, {"host:1", "abc"}), some_view());
  EXPECT_FALSE(read_view(file, {"", "abc"}).has_value());
  EXPECT_FALSE(read_view(file, {"host:1", "abd"}).has_value());
}

TEST(ViewState, AScanIsUpAsItWasSeenLast) {
  const TemporaryFolder folder;
  const auto file = folder / "views.toml";
  EXPECT_FALSE(read_up(file, "5ca4").has_value());
  ViewState view = some_view();
  ASSERT_TRUE(write_view(file, {"", "first"}, view).is_ok());
  view.camera.up = UpAxis::kX;
  ASSERT_TRUE(write_view(file, {"", "second"}, view).is_ok());
  EXPECT_EQ(read_up(file, "5ca4"), UpAxis::kX);
  EXPECT_FALSE(read_up(file, "5ca5").has_value());
}

TEST(ViewState, TheFileIsForItsUserAlone) {
  const TemporaryFolder folder;
  const auto file = folder / "below/views.toml";
  ASSERT_TRUE(write_view(file, {"", "abc"}, {}).is_ok());
  EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0600));
}

TEST(ViewState, TheOldestSessionsAndTheLastBookmarksAreDropped) {
  const TemporaryFolder folder;
  const auto file = folder / "views.toml";
  ViewState view;
  view.bookmarks.assign(kBookmarksMax + 5, Camera{});
  for (size_t i = 0; i < kViewsMax + 3; ++i)
    ASSERT_TRUE(write_view(file, {"", std::to_string(i)}, i == 50 ? view : ViewState{}).is_ok());
  EXPECT_FALSE(read_view(file, {"", "2"}).has_value());
  EXPECT_TRUE(read_view(file, {"", "3"}).has_value());
  EXPECT_EQ(read_view(file, {"", "50"})->bookmarks.size(), kBookmarksMax);
}

TEST(ViewState, ASessionThatIsWrittenAgainIsKeptOnceAndFirst) {
  const TemporaryFolder folder;
  const auto file = folder / "views.toml";
  ASSERT_TRUE(write_view(file, {"", "first"}, {}).is_ok());
  for (size_t i = 1; i < kViewsMax; ++i)
    ASSERT_TRUE(write_view(file, {"", std::to_string(i)}, {}).is_ok());
  ASSERT_TRUE(write_view(file, {"", "first"}, some_view()).is_ok());
  ASSERT_TRUE(write_view(file, {"", "one more"}, {}).is_ok());
  EXPECT_EQ(read_view(file, {"", "first"}), some_view());
  EXPECT_FALSE(read_view(file, {"", "1"}).has_value());
}

TEST(ViewState, DamageIsAnUnknownSession) {
  const TemporaryFolder folder;
  const auto file = folder / "views.toml";
  std::ofstream(file) << "[[views]]\nserver = \"\"\nsession = \"abc\"\n"
                         "camera = {distance = -1.0, target = [0.0, 0.0, 0.0]}\n";
  EXPECT_FALSE(read_view(file, {"", "abc"}).has_value());
  std::ofstream(file) << "[[views\n";
  EXPECT_FALSE(read_view(file, {"", "abc"}).has_value());
  ASSERT_TRUE(write_view(file, {"", "abc"}, some_view()).is_ok());
  EXPECT_TRUE(read_view(file, {"", "abc"}).has_value());
}

TEST(ViewState, OneRangeOfAnEarlierVersionIsThatOfBothEnds) {
  const TemporaryFolder folder;
  const auto file = folder / "views.toml";
  std::ofstream(file) << "[[views]]\nserver = \"\"\nsession = \"abc\"\ndisplacement_range = 4.0\n"
                         "camera = {distance = 1.0, target = [0.0, 0.0, 0.0]}\n";
  EXPECT_EQ(read_view(file, {"", "abc"})->options.displacement, (ColourEnds{4, 4}));
  EXPECT_EQ(read_view(file, {"", "abc"})->options.curvature, ColourEnds());
}

TEST(ViewState, ValuesBeyondTheirLimitsAreThoseOfANewView) {
  const TemporaryFolder folder;
  const auto file = folder / "views.toml";
  std::ofstream(file) << "[[views]]\nserver = \"\"\nsession = \"abc\"\ncolour = 99\n"
                         "light = {kind = \"neon\", specular = 40.0}\n"
                         "camera = {distance = 1.0, target = [0.0, 0.0, 0.0], up = \"w\"}\n";
  EXPECT_EQ(read_view(file, {"", "abc"}), ViewState{});
}

}  // namespace
}  // namespace burnish

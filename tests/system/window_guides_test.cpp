// The scale bar and the axes over the picture.

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

class GuidesWindow : public WindowTest {
 protected:
  bool has(const std::string& area) { return places_->find("Area/" + area).has_value(); }
};

TEST_F(GuidesWindow, BothLieOverThePictureUntilTheyAreSwitchedOff) {
  open_window();
  const Box bar = places_->wait_for("Area/Scale bar");
  EXPECT_GE(bar.width, 72);
  EXPECT_LE(bar.width, 180 + 14);
  for (const char* const end : {"Axis x", "Axis y", "Axis z", "Axis -x", "Axis -y", "Axis -z"})
    EXPECT_TRUE(has(end)) << end;
  save_screen("guides.png");
  click_on("View/Scale bar");
  click_on("View/Axes");
  EXPECT_TRUE(eventually([this] { return !has("Scale bar") && !has("Axis x"); }));
}

TEST_F(GuidesWindow, TheColourBarLiftsTheScaleBar) {
  open_window();
  const Box before = places_->wait_for("Area/Scale bar");
  click_on("View/Colour");
  click_on("View/Gradient scale β");
  const Box colours = places_->wait_for("Area/Colour bar");
  ASSERT_TRUE(eventually([&] {
    const auto bar = places_->find("Area/Scale bar");
    return bar && bar->y < before.y;
  }));
  const Box bar = places_->wait_for("Area/Scale bar");
  EXPECT_LE(bar.y + bar.height, colours.y);
  save_screen("guides-with-colours.png");
}

TEST_F(GuidesWindow, AClickOnAnEndOfAnAxisIsTheViewOfItsKeyAndNoStroke) {
  open_window();
  screen_->move(kPictureX, kPictureY);
  screen_->key({"3"});
  const Image right = settle();
  screen_->move(kPictureX, kPictureY);
  screen_->key({"Home"});
  EXPECT_TRUE(until_it_differs(right, 1));
  click_on("Area/Axis x");
  EXPECT_TRUE(until_it_is(right, 0.05));
  click_on("Area/Axis y");
  EXPECT_TRUE(until_it_differs(right, 1));
  EXPECT_TRUE(history().empty());
}

TEST_F(GuidesWindow, ADragOnTheAxesTurnsTheViewBackAndForth) {
  open_window();
  const Image front = settle();
  const Box end = places_->wait_for("Area/Axis y");
  const int x = end.x + end.width / 2, y = end.y + end.height / 2;
  screen_->drag(x, y, x + 150, y);
  EXPECT_TRUE(until_it_differs(front, 1));
  const Box then = places_->wait_for("Area/Axis y");
  screen_->drag(then.x + then.width / 2, then.y + then.height / 2, then.x + then.width / 2 - 150,
                then.y + then.height / 2);
  EXPECT_TRUE(until_it_is(front, 1));
  EXPECT_TRUE(history().empty());
}

}  // namespace
}  // namespace burnish

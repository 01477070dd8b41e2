// Menus and keys of the picture.

#include <gtest/gtest.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

class MenuWindow : public WindowTest {
 protected:
  bool is_there(const std::string& place) {
    return eventually([&] { return places_->find(place).has_value(); });
  }
  bool is_gone(const std::string& place) {
    return eventually([&] { return !places_->find(place).has_value(); });
  }
};

TEST_F(MenuWindow, AClickOfTheRightButtonOpensAMenuOfThePointAndADragMoves) {
  open_window();
  constexpr int kRight = 3;
  screen_->drag(kPictureX, kPictureY, kPictureX + 60, kPictureY, kRight);
  settle();
  EXPECT_FALSE(places_->find("Area/Picture menu").has_value());
  screen_->move(kPictureX, kPictureY);
  screen_->press(kRight);
  screen_->release(kRight);
  ASSERT_TRUE(is_there("Picture menu/Copy position"));
  save_screen("picture_menu.png");
  click_on("Picture menu/Copy position");
  EXPECT_TRUE(is_gone("Area/Picture menu"));
  EXPECT_TRUE(is_there("Area/Toasts"));
}

TEST_F(MenuWindow, ArrowsTurnTheView) {
  open_window();
  const Image front = settle();
  screen_->key({"Left"});
  EXPECT_TRUE(until_it_differs(front, 1));
  screen_->key({"Right"});
  EXPECT_TRUE(until_it_is(front, 1));
}

TEST_F(MenuWindow, AboutSaysWhereTheManualIs) {
  open_window();
  click_on("Menu/Help");
  ASSERT_TRUE(is_there("Menu/About"));
  click_on("Menu/About");
  EXPECT_TRUE(is_there("Area/About Burnish"));
  settle();
  save_screen("about.png");
}

}  // namespace
}  // namespace burnish

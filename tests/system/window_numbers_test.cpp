// Lengths that the window measures.

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

TEST_F(WindowTest, TheRulerMeasuresAndDoesNotPaint) {
  open_window();
  const Image before = settle();
  screen_->key({"m"});
  click(kPictureX - 60, kPictureY);
  click(kPictureX + 60, kPictureY);
  EXPECT_TRUE(until_it_differs(before, 0.1));
  save_screen("ruler.png");
  EXPECT_TRUE(history().empty());
  screen_->key({"m"});
  click(kPictureX, kPictureY);
  EXPECT_EQ(newest_of(1).kind, EditKind::kStroke);
}

// The bar lies at the lower right of the picture.
TEST_F(WindowTest, TheColourBarIsThereWithTheColoursThatItExplains) {
  constexpr int kColourX = 1160, kColourY = 71, kBetaColourY = 119, kBarX = 860, kBarY = 672;
  open_window();
  const auto is_blue = [&] {
    const Image image = screen_->capture();
    const uint8_t* rgb = image.pixel(kBarX, kBarY);
    return rgb[2] > rgb[0] + 60;
  };
  EXPECT_FALSE(is_blue());
  click(kColourX, kColourY);
  click(kColourX, kBetaColourY);
  screen_->move(kPictureX, kPictureY);
  EXPECT_TRUE(eventually(is_blue));
  save_screen("colour_bar.png");
}

TEST_F(WindowTest, ASectionAlongTheRulerIsShown) {
  constexpr int kColumnX = 1160, kColumnY = 400, kWheelDown = 5;
  constexpr int kSectionX = 1082, kSectionY = 635, kInWindowX = 700, kInWindowY = 540;
  open_window();
  screen_->key({"m"});
  click(kPictureX - 60, kPictureY);
  click(kPictureX + 60, kPictureY);
  settle();
  screen_->move(kColumnX, kColumnY);
  for (int i = 0; i < 30; ++i) {
    screen_->press(kWheelDown);
    screen_->release(kWheelDown);
  }
  const Image before = settle();
  click(kSectionX, kSectionY);
  EXPECT_TRUE(until_it_differs(before, 1));
  save_screen("section.png");
  screen_->key({"m"});  // the brush again, which must not paint through the window
  screen_->drag(kInWindowX - 100, kInWindowY, kInWindowX, kInWindowY);
  settle();
  EXPECT_TRUE(history().empty());
}

}  // namespace
}  // namespace burnish

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

}  // namespace
}  // namespace burnish

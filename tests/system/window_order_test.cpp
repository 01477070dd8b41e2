// The window after a stall: acts take effect in the order in which the user did them.

#include <csignal>

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr int kSmoothX = 50, kSharpenX = 227, kToolY = 421;

class StalledWindow : public WindowTest {
 protected:
  // Does all of it before the window sees any.
  void in_one_stall(const std::function<void()>& acts) {
    window_->signal(SIGSTOP);
    acts();
    window_->signal(SIGCONT);
  }
  void paint() { screen_->drag(kPictureX - 60, kPictureY, kPictureX + 60, kPictureY); }
};

TEST_F(StalledWindow, PaintsWithTheToolThatWasChosenLast) {
  open_window();
  click(kSharpenX, kToolY);
  paint();
  EXPECT_THAT(newest_of(1).summary, HasSubstr("beta 2"));
  save_screen("order.png");
  in_one_stall([this] {
    click(kSmoothX, kToolY);
    paint();
  });
  EXPECT_THAT(newest_of(2).summary, HasSubstr("beta 0"));
  in_one_stall([this] {
    click(kSharpenX, kToolY);
    paint();
    click(kSmoothX, kToolY);
    paint();
  });
  const HistoryEntry last = newest_of(4);
  EXPECT_THAT(history()[2].summary, HasSubstr("beta 2"));
  EXPECT_THAT(last.summary, HasSubstr("beta 0"));
}

TEST_F(StalledWindow, UndoesTheStrokeThatWasPaintedBefore) {
  open_window();
  in_one_stall([this] {
    paint();
    screen_->key({"Control_L", "z"});
  });
  ASSERT_EQ(newest_of(1).kind, EditKind::kStroke);
  EXPECT_TRUE(eventually([this] { return entries_on() == 0; }));
}

}  // namespace
}  // namespace burnish

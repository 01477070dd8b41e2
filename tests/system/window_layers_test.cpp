// The equaliser, the palette and the wavelength in the window.

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class LayerWindow : public WindowTest {
 protected:
  // The panels are below the others, and begin closed.
  void open_panel(const std::string& name) {
    scroll_down();
    click_on(name);
    scroll_down();
  }

  void scroll_down() {
    constexpr int kColumnX = 110, kColumnY = 400, kWheelDown = 5;
    screen_->move(kColumnX, kColumnY);
    for (int i = 0; i < 60; ++i) {
      screen_->press(kWheelDown);
      screen_->release(kWheelDown);
    }
    settle();
  }
};

TEST_F(LayerWindow, AGainThatIsDraggedMovesTheSurface) {
  open_window();
  open_panel("Equaliser");
  click_on("Equaliser/Make bands");
  EXPECT_THAT(newest_of(1).summary, HasSubstr("bands"));
  scroll_down();
  const Image before = settle();
  const Box gain = places_->wait_for("Equaliser/Gain of band 2");
  const int y = gain.y + gain.height / 2;
  screen_->drag(gain.x + gain.width / 3, y, gain.x + gain.width - 4, y);
  EXPECT_THAT(newest_of(2).summary, HasSubstr(":3"));
  EXPECT_TRUE(until_it_differs(before, 0.1));
  save_screen("equaliser.png");
}

TEST_F(LayerWindow, ABrushPaintsACurveOfThePalette) {
  open_window();
  open_panel("Palette");
  click_on("Palette/Name");
  screen_->type("letters");
  click_on("Palette/Add");
  EXPECT_EQ(newest_of(1).summary, "palette of 1 curve");
  scroll_down();
  click_on("Palette/letters");
  save_screen("palette.png");
  click(kPictureX, kPictureY);
  EXPECT_THAT(newest_of(2).summary, HasSubstr("curve 1"));
}

TEST_F(LayerWindow, AWavelengthThatIsTypedIsTheFidelity) {
  open_window();
  click_on("Filter/Wavelength as a number");
  screen_->type("0.5");
  screen_->key({"Return"});
  EXPECT_EQ(newest_of(1).kind, EditKind::kTransferCurve);
  save_screen("wavelength.png");
}

}  // namespace
}  // namespace burnish

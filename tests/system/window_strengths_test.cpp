// Small pictures of strengths in the window.

#include <algorithm>

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class StrengthsWindow : public WindowTest {
 protected:
  void choose_preset(const std::string& name) {
    click_on("Filter/Presets");
    click_on("Filter/" + name);
    newest_of(2);  // a curve and a gradient scale
    settle();
  }

  /// Returns how red, green and blue differ within a picture of the strip: a place that waits has
  /// one colour.
  static int contrast(const Image& image, const Box& box) {
    int low = 255, high = 0;
    for (int x = box.x + 4; x < box.x + box.width - 4; ++x) {
      const uint8_t* const pixel = image.pixel(x, box.y + box.height / 2);
      low = std::min(low, int{pixel[0]});
      high = std::max(high, int{pixel[0]});
    }
    return high - low;
  }
};

TEST_F(StrengthsWindow, AStrengthIsChosenByItsPicture) {
  open_window();
  EXPECT_FALSE(places_->find("Filter/Compare strengths")) << "no preset is in force";
  choose_preset("Soften");
  const Image before = settle();
  click_on("Filter/Compare strengths");
  for (const char* const strength : {"0.33", "0.67", "1.00"}) {
    const Box box = places_->wait_for(std::string("Filter/Strength ") + strength);
    EXPECT_GT(contrast(screen_->capture(), box), 10) << strength;
  }
  EXPECT_TRUE(until_it_is(before, 0.1)) << "the view is the session's again";
  save_screen("strengths.png");
  click_on("Filter/Strength 0.33");
  EXPECT_THAT(newest_of(3).summary, HasSubstr("beta 0.666"));
  EXPECT_TRUE(until_it_differs(before, 0.1));
  EXPECT_TRUE(places_->find("Filter/Strength 1.00")) << "the pictures stay";
  save_screen("strength-chosen.png");
}

TEST_F(StrengthsWindow, PicturesWithTheSameTextAreChosenEach) {
  open_window();
  choose_preset("Soften");
  const Edit nearly_all{"nearly", SetGradientScale{0.004}};
  ASSERT_TRUE(connection_->apply("desk", {&nearly_all, 1}).is_ok());
  newest_of(3);
  settle();
  click_on("Filter/Compare strengths");
  const Box first = places_->wait_for("Filter/Strength 1.00");  // 0.996
  settle();
  click(first.x + first.width + first.width / 2, first.y + first.height / 2);
  EXPECT_THAT(newest_of(4).summary, EndsWith("beta 0"));
}

TEST_F(StrengthsWindow, AFoldedPanelEndsTheTrial) {
  open_window();
  choose_preset("Soften");
  const Image before = settle();
  click_on("Filter/Compare strengths");
  click_on("Filter");
  EXPECT_TRUE(until_it_is(before, 0.1));
  click_on("Filter");
  places_->wait_for("Filter/Compare strengths");
  EXPECT_EQ(history().size(), 2u);
}

}  // namespace
}  // namespace burnish

// A pen that presses more or less hard, in the real window.

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include <gmock/gmock.h>

#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::ElementsAre;

#ifdef FAKE_PEN_LIBRARY

class PenWindow : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    press(0);
    setenv("BURNISH_FAKE_PEN", (server_->folder / "pen").c_str(), 1);
    preload_ = FAKE_PEN_LIBRARY;
    more_words_ = {"--record", (server_->folder / "record").string()};
    open_window();
  }

  void press(double pressure) const {
    const std::filesystem::path part = server_->folder / "pen.part";
    std::ofstream(part) << pressure;
    std::filesystem::rename(part, server_->folder / "pen");
  }
  /// Does what is one event for the window, and waits until it has asked the pen because of that.
  bool is_taken(const std::function<void()>& act) const {
    const size_t before = readings();
    act();
    return eventually([&] { return readings() > before; });
  }
  size_t readings() const {
    std::error_code error;  // there is no file before the first one
    const auto size = std::filesystem::file_size(server_->folder / "pen.read", error);
    return error ? 0 : size;
  }
  void draw() { screen_->drag(kPictureX - 40, kPictureY, kPictureX + 40, kPictureY); }

  // Waits for `count` strokes and returns their strengths.
  std::vector<double> strengths_of(size_t count) {
    newest_of(count);
    std::vector<double> strengths;
    std::ifstream lines(server_->folder / "record");
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string command;
      double radius = 0, strength = 0;
      if (words >> command >> radius >> strength && command == "stroke")
        strengths.push_back(strength);
    }
    return strengths;
  }
};

TEST_F(PenWindow, AMouseBesideAnIdlePenHasTheWholeStrength) {
  draw();
  EXPECT_THAT(strengths_of(1), ElementsAre(0.6));
  EXPECT_FALSE(places_->find("Brush/Pen pressure").has_value());
}

TEST_F(PenWindow, APensPressureScalesTheStrengthAndItsSwitchAppears) {
  press(0.5);
  draw();
  EXPECT_THAT(strengths_of(1), ElementsAre(0.3));
  save_screen("pen.png");
  click_on("Brush/Pen pressure");
  draw();
  EXPECT_THAT(strengths_of(2), ElementsAre(0.3, 0.6));
}

TEST_F(PenWindow, AGestureWhosePressureChangesIsUndoneAtOnce) {
  press(0.25);
  screen_->move(kPictureX - 60, kPictureY);
  ASSERT_TRUE(is_taken([this] { screen_->press(1); }));
  ASSERT_TRUE(is_taken([this] { screen_->move(kPictureX, kPictureY); }));
  press(1);
  ASSERT_TRUE(is_taken([this] { screen_->move(kPictureX + 60, kPictureY); }));
  press(0);
  screen_->release(1);
  EXPECT_THAT(strengths_of(2), ElementsAre(0.15, 0.6));
  screen_->key({"Control_L", "z"});
  EXPECT_TRUE(eventually([this] { return entries_on() == 0; }));
}

#endif

}  // namespace
}  // namespace burnish

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "client/scene/image.h"
#include "tests/system/places.h"
#include "tests/system/server_process.h"
#include "tests/system/x_display.h"

namespace burnish {

// Places of widgets at scale 1 on this screen, with the font that deploy/setup installs.
inline constexpr ImageSize kScreen{1280, 720};
inline constexpr int kPictureX = 660, kPictureY = 380, kReach = 120;
inline constexpr int kBetaY = 119, kBetaMiddleX = 107, kBetaLeftX = 30;

/// A server with the scan "blob" and its session "desk", and a screen for a window on them.
class WindowTest : public testing::Test {
 protected:
  void SetUp() override;

  // Starts `burnish window WORDS...`.
  void start_window(std::vector<std::string> words);
  void open_window(const std::string& timeout_seconds = "10", const std::string& scale = "1");

  static bool eventually(const std::function<bool()>& holds);

  // Colour of the square around the middle of the picture.
  struct Tone {
    double brightness = 0;
    double warmth = 0;  // red over blue: clay is warm, panels and background are cold
  };
  Tone tone_of(const Image& image) const;
  bool is_surface(const Image& image) const { return tone_of(image).warmth > 5; }
  bool shows_surface() {
    return eventually([this] { return is_surface(screen_->capture()); });
  }

  // Waits until a session is open and its surface is on the screen: a raw scan is shown before.
  bool shows_session() {
    return eventually([this] { return screen_->title().find("·") != std::string::npos; }) &&
           shows_surface();
  }

  // Returns the mean difference of a square around the middle of the picture.
  double difference(const Image& a, const Image& b) const;

  // Returns whether much of the square around the middle of the picture is not grey.
  bool has_colour(const Image& image) const;

  // Returns the picture once the pointer is away and nothing moves. The window is another process
  // and does not say so: four equal pictures, some time apart, must do. A grey picture has to rest
  // longer: the link may be lost, as after a pause of the machine, and comes back.
  Image settle();

  // Waits for a different picture: frames may still come while the picture rests.
  bool until_it_differs(const Image& from, double by) {
    return eventually([&] { return difference(from, settle()) > by; });
  }
  bool until_it_is(const Image& picture, double within) {
    return eventually([&] { return difference(picture, settle()) < within; });
  }

  void click(int x, int y) { screen_->drag(x, y, x, y); }
  // Clicks on the middle of a widget, by its name in Places.
  void click_on(const std::string& widget);
  // Turns the wheel over a column, e.g. "Left column", until the widget is seen.
  void scroll_to(const std::string& widget, const std::string& column);

  // Saves the screen in $BURNISH_SHOTS, for a look at a failing test.
  void save_screen(const std::string& name);

  std::vector<HistoryEntry> history();
  // Waits for `count` entries and returns the newest.
  HistoryEntry newest_of(size_t count);
  size_t entries_on();

  bool has_ended() { return window_->wait(std::chrono::milliseconds(0)).has_value(); }

  int middle_x_ = kPictureX;             // of the picture
  ImageSize window_size_ = kScreen;      // when it starts
  std::string preload_;                  // library for the window; empty: none
  std::vector<std::string> more_words_;  // for the window's command line
  std::unique_ptr<ServerProcess> server_;
  std::unique_ptr<Connection> connection_;
  std::unique_ptr<XDisplay> screen_;
  std::unique_ptr<Process> window_;
  std::unique_ptr<Places> places_;  // of the window
};

}  // namespace burnish

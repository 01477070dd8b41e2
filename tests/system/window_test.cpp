#include <csignal>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "client/scene/image.h"
#include "common/generate/generate.h"
#include "common/mesh/mesh_io.h"
#include "tests/system/link.h"
#include "tests/system/server_process.h"
#include "tests/system/x_display.h"

namespace burnish {
namespace {

constexpr ImageSize kScreen{1280, 720};

// Places of widgets at scale 1, with the font that deploy/setup installs.
constexpr int kPictureX = 660, kPictureY = 380, kReach = 120;
constexpr int kBetaY = 119, kBetaMiddleX = 107, kBetaLeftX = 30;
constexpr int kPlotX = 200, kPlotY = 290;
constexpr int kQuestionY = 345, kButtonsY = 394, kWaitX = 530, kDiscardX = 630;
constexpr int kColourX = 1160, kColourY = 71, kBetaColourY = 119;

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!XDisplay::is_available())
      GTEST_SKIP() << "Xvfb is not installed: deploy/setup installs it";
    server_ = std::make_unique<ServerProcess>();
    const auto scan = server_->folder / "blob.ply";
    const auto mesh = generate_scan({.kind = "blob", .vertices = 20'000});
    ASSERT_TRUE(mesh.is_ok());
    ASSERT_TRUE(write_mesh(*mesh, scan).is_ok());
    ASSERT_EQ(server_->burnish({"import", scan.string()}).exit_code, 0);
    ASSERT_EQ(server_->burnish({"open", "blob", "--session", "desk"}).exit_code, 0);
    connection_ = std::make_unique<Connection>(
        std::move(Connection::open(server_->address, kPatience)).value());
    screen_ = std::make_unique<XDisplay>(kScreen);
  }

  // Starts `burnish window WORDS...`.
  void start_window(std::vector<std::string> words) {
    setenv("DISPLAY", screen_->name().c_str(), 1);
#ifdef KEEP_LOADED_LIBRARY
    setenv("LD_PRELOAD", KEEP_LOADED_LIBRARY, 1);
    setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 1);
#endif
    words.insert(words.begin(), "window");
    words.insert(words.end(), {"--user", "ada", "--width", "1280", "--height", "720", "--config",
                               (server_->folder / "window.toml").string()});
    window_ = server_->start_burnish(std::move(words));
    unsetenv("LD_PRELOAD");
    screen_->focus_window();
  }

  void open_window(const std::string& timeout_seconds = "10", const std::string& scale = "1") {
    start_window({"--session", "desk", "--scale", scale, "--timeout", timeout_seconds});
    ASSERT_TRUE(eventually([&] { return is_surface(screen_->capture()); })) << window_->output();
    settle();
  }

  static bool eventually(const std::function<bool()>& holds) {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < deadline) {
      if (holds()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  // Colour of the square around the middle of the picture.
  struct Tone {
    double brightness = 0;
    double warmth = 0;  // red over blue: clay is warm, panels and background are cold
  };
  Tone tone_of(const Image& image) const {
    Tone sum;
    for (int y = kPictureY - kReach; y < kPictureY + kReach; ++y) {
      for (int x = middle_x_ - kReach; x < middle_x_ + kReach; ++x) {
        const uint8_t* rgb = image.pixel(x, y);
        sum.brightness += rgb[1];
        sum.warmth += int{rgb[0]} - int{rgb[2]};
      }
    }
    const double count = 4.0 * kReach * kReach;
    return {sum.brightness / count, sum.warmth / count};
  }

  bool is_surface(const Image& image) const {
    return tone_of(image).warmth > 5;
  }

  // Returns the mean difference of a square around the middle of the picture.
  double difference(const Image& a, const Image& b) const {
    double sum = 0;
    int count = 0;
    for (int y = kPictureY - kReach; y < kPictureY + kReach; ++y)
      for (int x = middle_x_ - kReach; x < middle_x_ + kReach; ++x)
        for (int c = 0; c < 3; ++c, ++count)
          sum += std::abs(int{a.pixel(x, y)[c]} - int{b.pixel(x, y)[c]});
    return sum / count;
  }

  // Returns the picture once the pointer is away and nothing moves. The window is another process
  // and does not say so: four equal pictures, some time apart, must do. A grey picture is not at
  // rest: the link is lost, as after a pause of the machine, and comes back.
  Image settle() {
    screen_->move(5, 700);
    Image last = screen_->capture();
    int still = 0;
    eventually([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
      Image now = screen_->capture();
      still = is_surface(now) && difference(now, last) == 0 ? still + 1 : 0;
      last = std::move(now);
      return still >= 4;
    });
    return last;
  }

  // Waits for a different picture: frames may still come while the picture rests.
  bool until_it_differs(const Image& from, double by) {
    return eventually([&] { return difference(from, settle()) > by; });
  }
  bool until_it_is(const Image& picture, double within) {
    return eventually([&] { return difference(picture, settle()) < within; });
  }

  // Returns whether the window asks about unsaved edits. The question lies over the middle; its
  // panel is darker than the picture.
  bool window_asks() {
    const Image image = screen_->capture();
    int dark = 0;
    for (int x = 500; x < 780; ++x) {
      const uint8_t* rgb = image.pixel(x, kQuestionY);
      dark += rgb[0] < 40 && rgb[1] < 42 && rgb[2] < 48;
    }
    return dark > 200;
  }

  // Paints a stroke that cannot be saved, because the server is gone.
  void paint_without_a_server() {
    open_window();
    server_->listen = server_->address;
    server_->kill();
    screen_->drag(kPictureX - 60, kPictureY, kPictureX + 60, kPictureY);
  }

  // Returns whether the start page says in green that it is connected.
  bool window_is_connected() {
    const Image image = screen_->capture();
    for (int x = 136; x < 320; ++x) {
      const uint8_t* rgb = image.pixel(x, 184);
      if (rgb[1] > 150 && rgb[0] < 140) return true;
    }
    return false;
  }

  std::vector<HistoryEntry> history() {
    // After a restart gRPC may still use the connection to the last server.
    EXPECT_TRUE(eventually([&] { return connection_->history("desk").is_ok(); }));
    return connection_->history("desk").value();
  }

  // Waits for `count` entries and returns the newest.
  HistoryEntry newest_of(size_t count) {
    EXPECT_TRUE(eventually([&] { return history().size() >= count; })) << window_->output();
    const auto entries = history();
    EXPECT_EQ(entries.size(), count);
    return entries.empty() ? HistoryEntry{} : entries.back();
  }

  size_t entries_on() {
    size_t on = 0;
    for (const HistoryEntry& entry : history()) on += entry.enabled;
    return on;
  }

  int middle_x_ = kPictureX;  // of the picture
  std::unique_ptr<ServerProcess> server_;
  std::unique_ptr<Connection> connection_;
  std::unique_ptr<XDisplay> screen_;
  std::unique_ptr<Process> window_;
};

TEST_F(WindowTest, AStrokeASliderACurvePointAndUndoChangeTheSessionAndThePicture) {
  open_window();
  const Image untouched = settle();

  screen_->drag(kPictureX - 60, kPictureY, kPictureX + 60, kPictureY);
  const HistoryEntry stroke = newest_of(1);
  EXPECT_EQ(stroke.kind, EditKind::kStroke);
  EXPECT_EQ(stroke.author, "ada");
  EXPECT_TRUE(until_it_differs(untouched, 0.3));
  const Image painted = settle();

  screen_->drag(kBetaMiddleX, kBetaY, kBetaLeftX, kBetaY);
  EXPECT_EQ(newest_of(2).kind, EditKind::kGradientScale);
  EXPECT_TRUE(eventually([&] { return connection_->state("desk")->gradient_scale < 0.3; }));
  EXPECT_TRUE(until_it_differs(painted, 1));
  const Image smoothed = settle();

  screen_->drag(kPlotX, kPlotY, kPlotX, kPlotY - 40);
  EXPECT_EQ(newest_of(3).kind, EditKind::kTransferCurve);
  EXPECT_TRUE(
      eventually([&] { return connection_->state("desk")->transfer_curve.points().size() == 2; }));
  EXPECT_TRUE(until_it_differs(smoothed, 0.1));

  screen_->move(kPictureX, kPictureY);
  for (size_t left : {2, 1, 0}) {
    screen_->key({"Control_L", "z"});
    ASSERT_TRUE(eventually([&] { return entries_on() == left; }));
  }
  EXPECT_TRUE(until_it_is(untouched, 0.05));
}

TEST_F(WindowTest, TheMiddleButtonTurnsAndHomeComesBackWithoutAnEdit) {
  open_window();
  const Image front = settle();
  screen_->drag(kPictureX, kPictureY, kPictureX + 200, kPictureY, 2);
  EXPECT_TRUE(until_it_differs(front, 1));
  screen_->drag(kPictureX, kPictureY, kPictureX - 200, kPictureY, 2);
  EXPECT_TRUE(until_it_is(front, 1));
  EXPECT_TRUE(history().empty());
}

// At 200 % there is one column, and the history is at its end.
TEST_F(WindowTest, InASmallWindowAllPanelsAreInOneColumnThatScrolls) {
  middle_x_ = 920;
  open_window("10", "2");
  constexpr int kColumnX = 300, kForkX = 390, kForkY = 173, kWheelDown = 5;
  screen_->move(kColumnX, 500);
  for (int i = 0; i < 30; ++i) {
    screen_->press(kWheelDown);
    screen_->release(kWheelDown);
  }
  settle();
  screen_->drag(kForkX, kForkY, kForkX, kForkY);
  EXPECT_TRUE(eventually([&] { return connection_->list_sessions()->size() == 2; }));
}

TEST_F(WindowTest, HidesAtOnceThoughACallWaitsForAStalledLink) {
  Link link(server_->address, {.delay = std::chrono::milliseconds(1)});
  server_->address = link.address();
  open_window("600");
  link.stall(true);
  screen_->drag(kColourX, kColourY, kColourX, kColourY);          // a list of views
  screen_->drag(kColourX, kBetaColourY, kColourX, kBetaColourY);  // the client fetches its colours
  window_->signal(SIGTERM);
  EXPECT_TRUE(eventually([&] { return !screen_->has_window(); }));
  EXPECT_FALSE(window_->wait(std::chrono::milliseconds(0)).has_value()) << window_->output();
}

TEST_F(WindowTest, FilesThatAreDroppedAreImportedAndTheFirstGoodOneIsOpened) {
  start_window({"--scale", "1"});
  ASSERT_TRUE(eventually([&] { return window_is_connected(); })) << window_->output();
  const auto letter = server_->folder.write("letter.txt", "Dear Sir");
  screen_->drop({letter, write_sphere(server_->folder, 3), write_sphere(server_->folder, 4)});
  EXPECT_TRUE(eventually([&] { return connection_->list_scans()->size() == 3; }));
  EXPECT_TRUE(eventually([&] { return is_surface(screen_->capture()); })) << window_->output();
  EXPECT_EQ(connection_->list_sessions()->size(), 2u);
}

TEST_F(WindowTest, SurvivesAServerThatDiesMidStrokeAndAWindowOfNoSize) {
  open_window();
  screen_->move(kPictureX - 60, kPictureY);
  screen_->press(1);
  for (int step = 0; step < 10; ++step) {
    screen_->move(kPictureX - 60 + 6 * step, kPictureY);
    if (step == 5) server_->kill();
  }
  screen_->release(1);
  screen_->resize_window({1, 1});
  screen_->resize_window({700, 400});
  screen_->resize_window(kScreen);
  // Grey: the picture may be out of date.
  EXPECT_TRUE(eventually([&] {
    const Tone tone = tone_of(screen_->capture());
    return tone.brightness > 60 && std::abs(tone.warmth) < 2;
  }));
  EXPECT_FALSE(window_->wait(std::chrono::milliseconds(0)).has_value()) << window_->output();
  window_->signal(SIGTERM);
  EXPECT_EQ(window_->wait(kPatience), 1);
  EXPECT_NE(window_->output().find("1 edit is not saved and will be lost"), std::string::npos)
      << window_->output();
}

TEST_F(WindowTest, AsksBeforeItClosesOverUnsavedEditsAndWaitsForThemIfAsked) {
  paint_without_a_server();
  screen_->close_window();
  ASSERT_TRUE(eventually([&] { return window_asks(); })) << window_->output();
  screen_->key({"Escape"});
  EXPECT_TRUE(eventually([&] { return !window_asks(); }));
  EXPECT_FALSE(window_->wait(std::chrono::milliseconds(0)).has_value()) << window_->output();

  screen_->close_window();
  ASSERT_TRUE(eventually([&] { return window_asks(); }));
  screen_->drag(kWaitX, kButtonsY, kWaitX, kButtonsY);
  server_->start();
  EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
  connection_ = std::make_unique<Connection>(
      std::move(Connection::open(server_->address, kPatience)).value());
  EXPECT_EQ(history().size(), 1u);
}

TEST_F(WindowTest, ClosesOverUnsavedEditsThatAreDiscarded) {
  paint_without_a_server();
  screen_->close_window();
  ASSERT_TRUE(eventually([&] { return window_asks(); })) << window_->output();
  screen_->drag(kDiscardX, kButtonsY, kDiscardX, kButtonsY);
  EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
  server_->start();
  connection_ = std::make_unique<Connection>(
      std::move(Connection::open(server_->address, kPatience)).value());
  EXPECT_TRUE(history().empty());
}

}  // namespace
}  // namespace burnish

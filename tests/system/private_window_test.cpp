// Real windows on the private server that they share (USERS B3, B4).

#include <csignal>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "client/scene/image.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/private_data.h"
#include "tests/system/server_process.h"
#include "tests/system/x_display.h"

namespace burnish {
namespace {

constexpr ImageSize kDesktop{1280, 720};
constexpr int kBrushX = 660, kBrushY = 380, kBrushReach = 100;

bool eventually(const std::function<bool()>& holds) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < deadline) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

/// A window on its own screen.
class PrivateWindow {
 public:
  PrivateWindow(const PrivateData& data, std::vector<std::string> words) {
    setenv("DISPLAY", screen.name().c_str(), 1);
#ifdef KEEP_LOADED_LIBRARY
    setenv("LD_PRELOAD", KEEP_LOADED_LIBRARY, 1);
    setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 1);
#endif
    words.insert(words.begin(), {BURNISH_BINARY, "window"});
    words.insert(words.end(),
                 {"--user", "ada", "--scale", "1", "--width", "1280", "--height", "720", "--data",
                  data.options.data.string(), "--config", (folder_ / "window.toml").string()});
    process = std::make_unique<Process>(words, folder_ / "output");
    unsetenv("LD_PRELOAD");
    screen.focus_window();
  }

  /// Returns whether the picture is clay. Clay is warm; it is grey without a connection; panels are
  /// cold.
  bool shows_clay() {
    const Image image = screen.capture();
    long warmth = 0;
    for (int y = kBrushY - kBrushReach; y < kBrushY + kBrushReach; ++y)
      for (int x = kBrushX - kBrushReach; x < kBrushX + kBrushReach; ++x)
        warmth += int{image.pixel(x, y)[0]} - int{image.pixel(x, y)[2]};
    return warmth > 5L * (2 * kBrushReach) * (2 * kBrushReach);
  }

  /// Waits for the session: a raw scan is shown before.
  bool until_it_shows_clay() {
    return eventually(
        [this] { return screen.title().find("·") != std::string::npos && shows_clay(); });
  }

  void paint() {
    screen.drag(kBrushX - 60, kBrushY, kBrushX + 60, kBrushY);
  }

  XDisplay screen{kDesktop};
  std::unique_ptr<Process> process;

 private:
  TemporaryFolder folder_;
};

class PrivateWindows : public testing::Test {
 protected:
  void SetUp() override {
    if (!XDisplay::is_available())
      GTEST_SKIP() << "Xvfb is not installed: deploy/setup installs it";
    const auto mesh = generate_scan({.kind = "blob", .vertices = 20'000});
    ASSERT_TRUE(mesh.is_ok());
    ASSERT_TRUE(write_mesh(*mesh, scan_).is_ok());
  }

  Connection connect() const {
    return Connection::open("unix:" + private_socket(data_.options.data).string(), kPatience)
        .value();
  }
  std::string session() const { return connect().list_sessions()->at(0).name; }
  bool until_edits_are(size_t count) const {
    return eventually([&] {
      auto connection = Connection::open("unix:" + private_socket(data_.options.data).string(),
                                         std::chrono::seconds(1));
      if (!connection.is_ok()) return false;
      const auto sessions = connection->list_sessions();
      return sessions.is_ok() && !sessions->empty() && sessions->at(0).edits == count;
    });
  }

  PrivateData data_;
  const std::filesystem::path scan_ = data_.folder / "blob.ply";
};

TEST_F(PrivateWindows, TheSecondGoesOnWhenTheFirstIsClosed) {
  PrivateWindow first(data_, {scan_.string()});
  ASSERT_TRUE(first.until_it_shows_clay()) << first.process->output();
  PrivateWindow second(data_, {"--session", session()});
  ASSERT_TRUE(second.until_it_shows_clay()) << second.process->output();
  const pid_t server = data_.server();
  first.screen.close_window();
  EXPECT_EQ(first.process->wait(kPatience), 0) << first.process->output();
  second.paint();
  EXPECT_TRUE(until_edits_are(1)) << second.process->output();
  EXPECT_TRUE(second.shows_clay());
  EXPECT_EQ(data_.server(), server);
}

TEST_F(PrivateWindows, AFileDroppedBeforeAServerIsChosenOpensAtOnce) {
  PrivateWindow window(data_, {});
  window.screen.drop({scan_});
  EXPECT_TRUE(window.until_it_shows_clay()) << window.process->output();
  EXPECT_EQ(session(), "blob");
}

TEST_F(PrivateWindows, OneComesBackWithItsEditsWhenTheServerIsKilled) {
  PrivateWindow window(data_, {scan_.string()});
  ASSERT_TRUE(window.until_it_shows_clay()) << window.process->output();
  const pid_t server = data_.server();
  window.screen.move(kBrushX - 60, kBrushY);
  window.screen.press(1);
  for (int x = kBrushX - 60; x <= kBrushX + 60; x += 10) {
    window.screen.move(x, kBrushY);
    if (x == kBrushX) kill(server, SIGKILL);
  }
  window.screen.release(1);
  EXPECT_TRUE(until_edits_are(1)) << window.process->output();
  EXPECT_TRUE(window.until_it_shows_clay());
  EXPECT_NE(data_.server(), server);
  EXPECT_FALSE(window.process->wait(std::chrono::milliseconds(0)).has_value());
}

}  // namespace
}  // namespace burnish

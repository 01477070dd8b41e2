#include "tests/system/window_fixture.h"

#include <algorithm>

#include "client/scene/png_writer.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"

namespace burnish {

void WindowTest::SetUp() {
  if (!XDisplay::is_available()) GTEST_SKIP() << "Xvfb is not installed: deploy/setup installs it";
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

void WindowTest::start_window(std::vector<std::string> words) {
  setenv("DISPLAY", screen_->name().c_str(), 1);
  std::string preload = preload_;
#ifdef KEEP_LOADED_LIBRARY
  preload += (preload.empty() ? "" : ":") + std::string(KEEP_LOADED_LIBRARY);
  setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 1);
#endif
  if (!preload.empty()) setenv("LD_PRELOAD", preload.c_str(), 1);
  words.insert(words.begin(), "window");
  words.insert(words.end(), more_words_.begin(), more_words_.end());
  words.insert(words.end(), {"--user", "ada", "--width", std::to_string(window_size_.width),
                             "--height", std::to_string(window_size_.height), "--config",
                             (server_->folder / "window.toml").string(), "--places",
                             (server_->folder / "places").string()});
  std::error_code ignored;
  std::filesystem::remove(server_->folder / "places", ignored);  // of the window before
  places_ = std::make_unique<Places>(server_->folder / "places");
  window_ = server_->start_burnish(std::move(words));
  unsetenv("LD_PRELOAD");
  screen_->focus_window();
}

void WindowTest::open_window(const std::string& timeout_seconds, const std::string& scale) {
  start_window({"--session", "desk", "--scale", scale, "--timeout", timeout_seconds});
  ASSERT_TRUE(shows_session()) << window_->output();
  settle();
}

void WindowTest::click_on(const std::string& widget) {
  const Box box = places_->wait_for(widget);
  click(box.x + box.width / 2, box.y + box.height / 2);
}

void WindowTest::scroll_to(const std::string& widget, const std::string& column) {
  constexpr int kWheelUp = 4, kWheelDown = 5, kTurnsMax = 80;
  const Box box = places_->wait_for("Area/" + column);
  screen_->move(box.x + 4, box.y + box.height / 2);
  const auto turn = [&](int button, int count) {
    for (int i = 0; i < count; ++i) screen_->press(button), screen_->release(button);
  };
  if (!places_->find(widget)) turn(kWheelUp, kTurnsMax);
  for (int i = 0; i < kTurnsMax && !places_->find(widget); ++i) turn(kWheelDown, 1);
}

bool WindowTest::eventually(const std::function<bool()>& holds) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < deadline) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

WindowTest::Tone WindowTest::tone_of(const Image& image) const {
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

bool WindowTest::has_colour(const Image& image) const {
  constexpr int kColourful = 12;
  int count = 0;
  for (int y = kPictureY - kReach; y < kPictureY + kReach; ++y) {
    for (int x = middle_x_ - kReach; x < middle_x_ + kReach; ++x) {
      const uint8_t* rgb = image.pixel(x, y);
      const auto [low, high] = std::minmax({rgb[0], rgb[1], rgb[2]});
      count += high - low >= kColourful;
    }
  }
  return count > kReach * kReach;  // a quarter
}

double WindowTest::difference(const Image& a, const Image& b) const {
  double sum = 0;
  int count = 0;
  for (int y = kPictureY - kReach; y < kPictureY + kReach; ++y)
    for (int x = middle_x_ - kReach; x < middle_x_ + kReach; ++x)
      for (int c = 0; c < 3; ++c, ++count)
        sum += std::abs(int{a.pixel(x, y)[c]} - int{b.pixel(x, y)[c]});
  return sum / count;
}

Image WindowTest::settle() {
  screen_->move(5, 700);
  constexpr int kStill = 4, kStillOfGrey = 20;
  Image last = screen_->capture();
  int still = 0;
  eventually([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    Image now = screen_->capture();
    still = difference(now, last) == 0 ? still + 1 : 0;
    last = std::move(now);
    return still >= (has_colour(last) ? kStill : kStillOfGrey);
  });
  return last;
}

void WindowTest::save_screen(const std::string& name) {
  const char* const folder = std::getenv("BURNISH_SHOTS");
  if (!folder) return;
  EXPECT_TRUE(write_png(screen_->capture(), std::filesystem::path(folder) / name).is_ok());
}

std::vector<HistoryEntry> WindowTest::history() {
  // After a restart gRPC may still use the connection to the last server.
  EXPECT_TRUE(eventually([&] { return connection_->history("desk").is_ok(); }));
  return connection_->history("desk").value();
}

HistoryEntry WindowTest::newest_of(size_t count) {
  EXPECT_TRUE(eventually([&] { return history().size() >= count; })) << window_->output();
  const auto entries = history();
  EXPECT_EQ(entries.size(), count);
  return entries.empty() ? HistoryEntry{} : entries.back();
}

size_t WindowTest::entries_on() {
  size_t on = 0;
  for (const HistoryEntry& entry : history()) on += entry.enabled;
  return on;
}

}  // namespace burnish

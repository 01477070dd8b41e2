// The effect of files dropped on the window, without the window.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/scene/null_page_renderer.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/link.h"
#include "tests/system/server_process.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// A start page connected to a server without scans.
class WindowImport : public testing::Test {
 protected:
  explicit WindowImport(WorkspaceOptions options = {})
      : workspace_(renderer_, Preferences(), std::move(options)) {}

  template <typename What>
  bool until(What what) {
    return pictures_until(workspace_, what);
  }
  bool until_idle() {
    return until([this] { return workspace_.is_idle() && workspace_.activities().empty(); });
  }

  void connect(const std::string& address) {
    workspace_.viewport.set_size({400, 300});
    workspace_.connect(address);
    ASSERT_TRUE(until([this] {
      return workspace_.library().state == Library::State::kConnected && workspace_.is_idle();
    }));
  }

  /// Writes a scan of some megabytes, or of a size that ThreadSanitizer prepares in seconds.
  std::filesystem::path write_large() const {
#if defined(__SANITIZE_THREAD__)
    constexpr int kLevel = 6;
#else
    constexpr int kLevel = 7;
#endif
    const auto path = server_.folder / "large.ply";
    EXPECT_TRUE(write_mesh(make_icosphere(kLevel, 1), path).is_ok());
    return path;
  }

  std::string phase() const {
    return workspace_.activities().empty() ? "" : workspace_.activities().front()->state().phase;
  }

  std::string last_message(Severity severity) const {
    const auto& messages = workspace_.log.messages();
    for (auto message = messages.rbegin(); message != messages.rend(); ++message)
      if (message->severity == severity) return message->text;
    return {};
  }
  size_t errors() const {
    const auto& messages = workspace_.log.messages();
    return static_cast<size_t>(
        std::count_if(messages.begin(), messages.end(),
                      [](const Message& each) { return each.severity == Severity::kError; }));
  }

  void expect_nothing_is_left() {
    EXPECT_TRUE(until([this] { return server_.staged() == 0; }));
    EXPECT_EQ(server_.scans(), 0u);
    EXPECT_EQ(workspace_.document(), nullptr);
  }

  ServerProcess server_;
  NullPageRenderer renderer_;
  Workspace workspace_;
};

/// A start page that shows files before it imports them, as the window does.
class RawImport : public WindowImport {
 protected:
  RawImport() : WindowImport({.shows_raw = true}) {}
};

TEST_F(WindowImport, OpensWhatItImported) {
  connect(server_.address);
  workspace_.import_scan(write_sphere(server_.folder));
  ASSERT_TRUE(
      until([this] { return workspace_.document() && workspace_.document()->is_settled(); }));
  EXPECT_EQ(workspace_.document()->scan().scan.name, "sphere3");
  EXPECT_EQ(errors(), 0u);
}

TEST_F(WindowImport, OfSeveralFilesTheGoodOnesComeAndTheOthersAreNamed) {
  connect(server_.address);
  const auto garbage = server_.folder.write("garbage.ply", "ply\nformat ascii 1.0\nnonsense\n");
  const auto letter = server_.folder.write("letter.txt", "Dear Sir");
  std::filesystem::create_directory(server_.folder / "folder.ply");
  for (const std::filesystem::path& file :
       {garbage, std::filesystem::path(write_sphere(server_.folder, 3)), letter,
        server_.folder / "folder.ply", server_.folder / "nowhere.ply",
        std::filesystem::path(write_sphere(server_.folder, 2))})
    workspace_.import_scan(file);
  ASSERT_TRUE(until_idle());
  EXPECT_EQ(errors(), 4u);
  std::string told;
  for (const Message& message : workspace_.log.messages()) told += message.text + "\n";
  for (const char* name : {"garbage.ply", "letter.txt", "folder.ply", "nowhere.ply"})
    EXPECT_THAT(told, HasSubstr(name));
  EXPECT_EQ(server_.scans(), 2u);
  EXPECT_EQ(server_.staged(), 0u);
  EXPECT_NE(workspace_.document(), nullptr);
}

TEST_F(WindowImport, CanBeCancelledWhileItUploads) {
  Link link(server_.address, {.megabits_per_second = 8, .delay = milliseconds(1)});
  connect(link.address());
  workspace_.import_scan(write_large());
  ASSERT_TRUE(until([this] { return phase() == "uploading"; }));
  workspace_.activities().front()->cancel();
  ASSERT_TRUE(until_idle());
  EXPECT_EQ(errors(), 0u);
  EXPECT_THAT(last_message(Severity::kInfo), HasSubstr("large.ply"));
  expect_nothing_is_left();
}

TEST_F(WindowImport, CanBeCancelledWhileItIsPrepared) {
  connect(server_.address);
  workspace_.import_scan(write_large());
  ASSERT_TRUE(until([this] { return phase() == "curvature" || phase() == "integrals"; }));
  workspace_.activities().front()->cancel();
  ASSERT_TRUE(until_idle());
  EXPECT_EQ(errors(), 0u);
  expect_nothing_is_left();
}

TEST_F(WindowImport, SaysWhenTheServerIsLostAndComesAgainThere) {
  Link link(server_.address, {.megabits_per_second = 8, .delay = milliseconds(1)});
  connect(link.address());
  const auto file = write_large();
  workspace_.import_scan(file);
  ASSERT_TRUE(until([this] { return phase() == "uploading"; }));
  server_.listen = server_.address;
  server_.kill();
  ASSERT_TRUE(until_idle());
  EXPECT_GE(errors(), 1u);
  EXPECT_THAT(last_message(Severity::kError), HasSubstr("large.ply"));
  EXPECT_EQ(workspace_.document(), nullptr);
  server_.start();
  connect(server_.address);
  EXPECT_EQ(server_.staged(), 0u);
  workspace_.import_scan(file);
  EXPECT_TRUE(until([this] { return workspace_.document() != nullptr; }));
}

TEST_F(RawImport, AFileIsSeenAndTurnedBeforeItsSessionIsThere) {
  connect(server_.address);
  workspace_.import_scan(write_large());
  ASSERT_TRUE(until([this] { return workspace_.raw() != nullptr; }));
  EXPECT_EQ(workspace_.document(), nullptr);
  ASSERT_TRUE(workspace_.draw().is_ok());
  EXPECT_FALSE(renderer_.patches().empty());
  Viewport& viewport = workspace_.viewport;
  const double azimuth = viewport.camera.azimuth_degrees;
  viewport.press(PointerButton::kLeft, {}, {100, 100});
  viewport.move({150, 100});
  const double turned = viewport.camera.azimuth_degrees;
  EXPECT_NE(turned, azimuth);
  ASSERT_TRUE(until([this] { return workspace_.document() != nullptr; }));
  EXPECT_EQ(workspace_.raw(), nullptr);
  EXPECT_EQ(viewport.camera.azimuth_degrees, turned);
  viewport.move({200, 100});  // the same drag
  EXPECT_NE(viewport.camera.azimuth_degrees, turned);
  viewport.release(PointerButton::kLeft);
}

TEST_F(RawImport, TheWholeHasOneProgressThatRises) {
  connect(server_.address);
  workspace_.import_scan(write_large());
  double before = 0;
  ASSERT_TRUE(until([this] { return workspace_.raw() != nullptr; }));
  ASSERT_TRUE(until([&] {
    if (workspace_.activities().empty()) return workspace_.document() != nullptr;
    EXPECT_EQ(workspace_.activities().size(), 1u);
    const double now = workspace_.activities().front()->state().fraction;
    EXPECT_GE(now, before);
    before = now;
    return false;
  }));
  EXPECT_GT(before, 0.5);
}

TEST_F(RawImport, AFileThatCannotBeReadIsNamedAndNothingIsShown) {
  connect(server_.address);
  workspace_.import_scan(server_.folder.write("garbage.ply", "ply\nformat ascii 1.0\nnonsense\n"));
  ASSERT_TRUE(until_idle());
  EXPECT_THAT(last_message(Severity::kError), HasSubstr("garbage.ply"));
  EXPECT_EQ(errors(), 1u);
  EXPECT_FALSE(workspace_.has_picture());
  workspace_.import_scan(write_sphere(server_.folder));
  EXPECT_TRUE(until([this] { return workspace_.document() != nullptr; }));
}

TEST_F(RawImport, CancellingClosesTheRawScan) {
  connect(server_.address);
  workspace_.import_scan(write_large());
  ASSERT_TRUE(until([this] { return workspace_.raw() && !workspace_.activities().empty(); }));
  workspace_.activities().front()->cancel();
  ASSERT_TRUE(until_idle());
  EXPECT_FALSE(workspace_.has_picture());
  EXPECT_EQ(errors(), 0u);
}

}  // namespace
}  // namespace burnish

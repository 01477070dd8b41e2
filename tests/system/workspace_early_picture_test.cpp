#include <fstream>

#include <gtest/gtest.h>

#include "client/scene/null_page_renderer.h"
#include "tests/common/fast_clock.h"
#include "tests/system/server_process.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

/// A workspace at a server that opens no session until open_gate().
class EarlyPicture : public testing::Test {
 protected:
  EarlyPicture() {
    ::setenv("LD_PRELOAD", HOLD_OPENING_LIBRARY, 1);
    ::setenv("BURNISH_GATE", gate().c_str(), 1);
    server_.kill();
    server_.start();
    ::unsetenv("LD_PRELOAD");
    Connection owner = Connection::open(server_.address, kPatience).value();
    EXPECT_TRUE(owner.import_scan(write_sphere(server_.folder, 6), "ball", {6, 0}, {}).is_ok());
    workspace_.viewport.set_size({400, 300});
    workspace_.connect(server_.address);
    EXPECT_TRUE(until([this] { return !workspace_.library().scans.empty(); }));
  }
  ~EarlyPicture() override { open_gate(); }

  std::filesystem::path gate() const { return server_.folder / "gate"; }
  void open_gate() const { std::ofstream(gate()) << "open\n"; }
  template <typename What>
  bool until(What what) {
    return pictures_until(workspace_, what);
  }
  void open_ball() { workspace_.open_scan(workspace_.library().scans.front(), Opening::kGoOn); }

  ServerProcess server_;
  NullPageRenderer renderer_;
  FastClock clock_;
  Workspace workspace_{renderer_, Preferences(),
                       WorkspaceOptions{.preferences = server_.folder / "config/window.toml",
                                        .clock = clock_.clock()}};
};

TEST_F(EarlyPicture, AScanIsSeenAndTurnedBeforeItsSessionIsOpen) {
  open_ball();
  ASSERT_TRUE(until([this] { return workspace_.raw() != nullptr; }));
  const RawScan& raw = *workspace_.raw();
  EXPECT_EQ(raw.name, "ball");
  EXPECT_EQ(raw.triangles, workspace_.library().scans.front().statistics.triangles);
  EXPECT_TRUE(raw.file.empty());
  EXPECT_GT(drawn_triangles(raw), raw.triangles / 8) << "the coarse level that one request brings";
  EXPECT_TRUE(workspace_.has_picture());
  EXPECT_TRUE(workspace_.draw().is_ok());
  EXPECT_EQ(workspace_.document(), nullptr);
  workspace_.viewport.camera.azimuth_degrees = 77;
  const Camera seen = workspace_.viewport.camera;
  open_gate();
  ASSERT_TRUE(until([this] { return workspace_.document() != nullptr; }));
  EXPECT_EQ(workspace_.raw(), nullptr);
  EXPECT_EQ(workspace_.viewport.camera.azimuth_degrees, 77);
  EXPECT_TRUE(workspace_.keeps_raw_picture(seen)) << "no page is here yet";
  ASSERT_TRUE(until([this] { return workspace_.document()->is_picture_settled(); }));
  EXPECT_FALSE(workspace_.keeps_raw_picture(seen));
}

TEST_F(EarlyPicture, ASessionIsSeenEarlyAsItWasLeft) {
  RecentSession recent{.server = server_.address, .session = "ball", .scan = "", .id = "left"};
  recent.scan = workspace_.library().scans.front().id;
  workspace_.preferences.recent.push_back(recent);
  ViewState left;
  left.camera.azimuth_degrees = 123;
  left.options.lighting.kind = LightKind::kCavity;
  const auto views = server_.folder / "config/views.toml";
  std::filesystem::create_directories(views.parent_path());
  ASSERT_TRUE(write_view(views, {server_.address, "left"}, left).is_ok());
  open_ball();
  ASSERT_TRUE(until([this] { return workspace_.raw() != nullptr; }));
  EXPECT_EQ(workspace_.viewport.camera.azimuth_degrees, 123);
  EXPECT_EQ(workspace_.viewport.options.lighting.kind, LightKind::kCavity);
}

TEST_F(EarlyPicture, GoesWhenItsSessionCannotBeOpened) {
  open_ball();
  ASSERT_TRUE(until([this] { return workspace_.raw() != nullptr; }));
  server_.kill();
  ASSERT_TRUE(until([this] { return !workspace_.is_opening(); }));
  EXPECT_FALSE(workspace_.has_picture());
  EXPECT_FALSE(workspace_.log.messages().empty());
}

TEST_F(EarlyPicture, ComesFromTheServerOfItsOpeningThoughTheUserHasGoneToAnother) {
  open_ball();
  workspace_.connect("127.0.0.1:1");
  ASSERT_TRUE(until([this] { return workspace_.raw() != nullptr; }));
  open_gate();
  ASSERT_TRUE(until([this] { return workspace_.document() != nullptr; }));
}

TEST_F(EarlyPicture, AScanThatIsOpenStaysWhileAnotherOpens) {
  open_gate();
  open_ball();
  ASSERT_TRUE(until([this] { return workspace_.document() != nullptr; }));
  std::filesystem::remove(gate());
  workspace_.open_scan(workspace_.library().scans.front(), Opening::kAnew, 5);
  EXPECT_EQ(workspace_.raw(), nullptr);
  EXPECT_NE(workspace_.document(), nullptr);
  open_gate();
  ASSERT_TRUE(until([this] { return workspace_.document()->depth() == 5; }));
  EXPECT_EQ(workspace_.raw(), nullptr);
}

}  // namespace
}  // namespace burnish

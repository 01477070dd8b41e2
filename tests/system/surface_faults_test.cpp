// A window shows its surface while pages do not come: the server is full, dead, silent or damaged.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/model/workspace/workspace.h"
#include "client/scene/null_page_renderer.h"
#include "tests/common/fast_clock.h"
#include "tests/system/link.h"
#include "tests/system/server_process.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// A window without pictures that is open on a ball of 163,842 vertices.
class SurfaceFaults : public testing::Test {
 protected:
  SurfaceFaults() {
    server_.listen = server_.address;
    const std::string ball = write_sphere(server_.folder, 7);
    Connection owner = Connection::open(server_.address, kPatience).value();
    EXPECT_TRUE(owner.import_scan(ball, "ball", {5, 0}, {}).is_ok());
  }

  /// Starts the server again with these limits.
  void limit(const std::string& limits) {
    server_.flags = {"--config", server_.folder.write("server.toml", limits).string()};
    server_.kill();
    server_.start();
  }

  void open() {
    Connection owner = Connection::open(server_.address, kPatience).value();
    const auto opened = owner.open_session({"ball", "work", {5, 0}});
    ASSERT_TRUE(opened.is_ok()) << opened.status().message();
    link_ = std::make_unique<Link>(server_.address, LinkOptions{.delay = milliseconds(5)});
    workspace_.viewport.set_size({1280, 720});
    workspace_.when_connected([this] { workspace_.join_by_name("work"); });
    workspace_.connect(link_->address());
    ASSERT_TRUE(until([this] { return workspace_.document() && has_surface(); }));
  }

  template <typename What>
  bool until(What what) {
    return pictures_until(workspace_, what);
  }
  /// Takes pictures until what() holds. Each must show a surface.
  template <typename What>
  bool shows_surface_until(What what) {
    return until([&] {
      EXPECT_TRUE(has_surface());
      return !has_surface() || what();
    });
  }
  /// Comes nearer with each of so many pictures. Each must show a surface.
  void fly_nearer(int pictures) {
    EXPECT_TRUE(shows_surface_until([&, left = pictures]() mutable {
      workspace_.viewport.camera.distance *= 0.95;
      return --left <= 0;
    }));
  }

  Document& document() { return *workspace_.document(); }
  CutStatus status() { return document().surface().status(); }
  bool has_surface() { return !document().surface().patches().empty(); }
  bool is_full() {
    return document().is_settled() && document().is_picture_settled() && status().is_full_detail;
  }
  std::string messages() const {
    std::string text = status_text(workspace_.document()->surface().status());
    for (const Message& message : workspace_.log.messages()) text += "\n" + message.text;
    return text;
  }
  size_t times_lost() const { return count_of("connection lost"); }
  size_t count_of(const std::string& text) const {
    size_t count = 0;
    for (const Message& message : workspace_.log.messages())
      count += message.text.find(text) != std::string::npos;
    return count;
  }

  ServerProcess server_;
  std::unique_ptr<Link> link_;
  NullPageRenderer renderer_;
  FastClock clock_;
  Workspace workspace_{renderer_, Preferences(), WorkspaceOptions{.clock = clock_.clock()}};
};

TEST_F(SurfaceFaults, AServerWithoutMemoryForAllPagesIsAskedForFewer) {
  limit("[limits]\nmemory_bytes_max = 52000000\n");
  open();
  ASSERT_TRUE(shows_surface_until([this] {
    return times_lost() > 0 && document().is_settled() && document().is_picture_settled() &&
           status().reason == CutReason::kServer;
  })) << messages();
  EXPECT_THAT(status_text(status()), HasSubstr("the server has no memory for more"));
  EXPECT_LE(times_lost(), 6u) << "it must not ask for the same again and again";
}

TEST_F(SurfaceFaults, AServerKilledInAFlightComesBackToFullDetail) {
  open();
  fly_nearer(5);
  server_.kill();
  fly_nearer(10);
  ASSERT_TRUE(shows_surface_until([this] { return document().link() == LinkState::kLost; }));
  fly_nearer(5);
  EXPECT_FALSE(status().is_full_detail);
  server_.start();
  EXPECT_TRUE(shows_surface_until([this] { return is_full(); })) << status_text(status());
}

// Ten seconds by the window's clock. It, gRPC and the server wait longer for a silent peer.
TEST_F(SurfaceFaults, ALinkThatStallsForTenSecondsLeavesTheSurfaceThatIsThere) {
  open();
  link_->stall(true);
  for (int second = 0; second < 10; ++second) {
    fly_nearer(2);
    clock_.put_forward(std::chrono::seconds(1));
  }
  EXPECT_EQ(status().reason, CutReason::kLoading);
  link_->stall(false);
  EXPECT_TRUE(shows_surface_until([this] { return is_full(); })) << status_text(status());
}

TEST_F(SurfaceFaults, PagesDamagedOnTheServerAreMadeAgain) {
  open();
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(server_.folder / "data" / "scans"))
    if (entry.path().extension() == ".pages") std::filesystem::resize_file(entry.path(), 100);
  fly_nearer(20);
  EXPECT_TRUE(shows_surface_until([this] {
    EXPECT_NE(status().reason, CutReason::kServer);
    return is_full();
  })) << status_text(status());
  EXPECT_GE(count_of("makes the pages of the scan again"), 1u);
}

}  // namespace
}  // namespace burnish

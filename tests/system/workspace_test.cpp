#include "client/model/workspace/workspace.h"

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/scene/null_page_renderer.h"
#include "tests/common/fast_clock.h"
#include "tests/system/link.h"
#include "tests/system/server_process.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

/// A Workspace without a window: everything that the window does, on a session over a sphere.
class WorkspaceService : public testing::Test {
 protected:
  WorkspaceService() {
    EXPECT_TRUE(owner_.import_scan(write_sphere(server_.folder, 3), "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(owner_.open_session({"ball", "work", {5, 0}}).is_ok());
    workspace_.viewport.set_size({400, 300});
  }

  template <typename What>
  bool until(What what) {
    return pictures_until(workspace_, what);
  }

  bool open_through(const std::string& server) {
    workspace_.when_connected([this] { workspace_.join_by_name("work"); });
    workspace_.connect(server);
    return until([this] {
      return workspace_.document() && document().is_settled() && document().is_picture_settled();
    });
  }

  bool until_link_is(LinkState state) {
    return until([&] { return document().link() == state; });
  }

  Document& document() { return *workspace_.document(); }

  /// Uses a little of every feature.
  void use_everything() {
    Viewport& viewport = workspace_.viewport;
    viewport.press(PointerButton::kLeft, {}, {190, 150});
    for (int x = 190; x <= 220; x += 10) {
      viewport.move({double(x), 150});
      workspace_.update();
    }
    viewport.release(PointerButton::kLeft);
    workspace_.update();
    document().preview_beta(0.5);
    document().commit_beta();
    document().undo();
    document().set_checkpoint("here");
    document().set_role("bert", SessionRole::kViewer);
    for (ColourBy colour : {ColourBy::kBeta, ColourBy::kCurvature}) document().set_colour(colour);
    workspace_.export_mesh(server_.folder / "out.ply", false);
    EXPECT_TRUE(until([this] { return workspace_.is_idle(); }));
  }

  bool log_has(const std::string& text) const {
    for (const Message& message : workspace_.log.messages())
      if (message.text.find(text) != std::string::npos) return true;
    return false;
  }

  ServerProcess server_;
  Connection owner_ = Connection::open(server_.address, kPatience).value();
  NullPageRenderer renderer_;
  FastClock clock_;
  Workspace workspace_{renderer_, Preferences(), WorkspaceOptions{.clock = clock_.clock()}};
};

TEST_F(WorkspaceService, ARenamedSessionIsOpenedAgainUnderItsNewName) {
  ASSERT_TRUE(open_through(server_.address));
  ASSERT_EQ(workspace_.preferences.recent.size(), 1u);
  workspace_.close_document();
  ASSERT_TRUE(until([this] { return !workspace_.library().sessions.empty(); }));
  workspace_.rename_session(workspace_.library().sessions[0], "carving");
  ASSERT_TRUE(until([this] { return workspace_.preferences.recent[0].session == "carving"; }));
  ASSERT_TRUE(owner_.rename_session("carving", "relief").is_ok());  // nobody tells the window
  workspace_.reopen(RecentSession(workspace_.preferences.recent[0]));
  ASSERT_TRUE(until([this] { return workspace_.document() != nullptr; }));
  EXPECT_EQ(document().session().name, "relief");
  EXPECT_EQ(owner_.list_sessions()->size(), 1u);
}

TEST_F(WorkspaceService, AScanThatFitsIsShownInFullDetail) {
  ASSERT_TRUE(open_through(server_.address));
  const CutStatus status = document().surface().status();
  EXPECT_EQ(status_text(status), "full detail");
  EXPECT_EQ(status.triangles_drawn, document().scan().scan.statistics.triangles);
}

TEST_F(WorkspaceService, SaysWhetherAllEditsAreSaved) {
  ASSERT_TRUE(open_through(server_.address));
  workspace_.tell_saved();
  EXPECT_TRUE(log_has("all edits are saved"));
  server_.kill();
  document().preview_beta(0.5);
  document().commit_beta();
  workspace_.tell_saved();
  EXPECT_TRUE(log_has("1 edit is not saved yet"));
}

TEST_F(WorkspaceService, AFileThatTakesTheSessionsPlaceIsOpenedAndAnotherIsOnlyImported) {
  ASSERT_TRUE(open_through(server_.address));
  const TemporaryFolder folder;
  const std::string first = write_sphere(folder, 2), second = write_sphere(server_.folder, 4);
  workspace_.import_in_place(first);
  workspace_.import_in_place(second);
  ASSERT_TRUE(until([this] { return workspace_.library().scans.size() == 3; }));
  ASSERT_TRUE(until([this] { return workspace_.is_idle() && workspace_.document(); }));
  EXPECT_EQ(document().scan().scan.name, "sphere2");
}

TEST_F(WorkspaceService, LeavesASessionThatItsOwnerClosedUntilItIsOpenedAgain) {
  ASSERT_TRUE(open_through(server_.address));
  ASSERT_TRUE(owner_.close_session("work").is_ok());
  ASSERT_TRUE(until_link_is(LinkState::kEnded));
  EXPECT_TRUE(log_has("the session was closed by"));
  workspace_.join_by_name("work");
  ASSERT_TRUE(until([this] { return document().link() == LinkState::kLive; }));
  use_everything();
  EXPECT_TRUE(until([this] { return document().is_settled(); }));
}

TEST_F(WorkspaceService, OutlivesItsSessionAndItsScan) {
  ASSERT_TRUE(open_through(server_.address));
  workspace_.viewport.press(PointerButton::kLeft, {}, {190, 150});
  workspace_.viewport.move({200, 150});
  ASSERT_TRUE(until([this] { return document().brush().is_drawing(); }));
  ASSERT_TRUE(owner_.delete_session("work").is_ok());
  ASSERT_TRUE(owner_.delete_scan("ball").is_ok());
  ASSERT_TRUE(until_link_is(LinkState::kEnded));
  EXPECT_TRUE(log_has("session ended"));
  workspace_.viewport.release(PointerButton::kLeft);
  use_everything();
  EXPECT_TRUE(workspace_.viewport.style(document()).faded);
  EXPECT_FALSE(document().brush().is_drawing());
  EXPECT_FALSE(document().surface().is_tinted()) << "no frame will show those strokes";
  workspace_.close_document();
  ASSERT_TRUE(until([this] { return workspace_.is_idle(); }));
  EXPECT_TRUE(workspace_.library().scans.empty());
}

TEST_F(WorkspaceService, BringsWhatWasEditedWhileTheServerWasDead) {
  ASSERT_TRUE(open_through(server_.address));
  server_.listen = server_.address;
  server_.kill();
  ASSERT_TRUE(until_link_is(LinkState::kLost));
  document().preview_beta(0.25);
  document().commit_beta();
  document().paint({{.radius = 0.3, .beta = 2}, {Vec3d(0, 0, 1)}});
  workspace_.update();
  EXPECT_EQ(document().unacknowledged(), 2u);
  EXPECT_EQ(document().beta(), 0.25);
  server_.start();
  ASSERT_TRUE(until([this] {
    return document().is_settled() && document().stats().frame.edits == 2 &&
           document().history().size() == 2;
  }));
  EXPECT_EQ(document().beta(), 0.25);
  EXPECT_EQ(owner_.history("work")->size(), 2u);
}

// Frames, values and history come separately, each with the delay of the link.
TEST_F(WorkspaceService, WhatIsSettledHasItsValuesAndItsHistory) {
  Link link(server_.address, {.delay = milliseconds(50)});
  ASSERT_TRUE(open_through(link.address()));
  const auto is_settled = [this] { return document().is_settled(); };
  for (const double beta : {0.25, 2.0}) {
    document().preview_beta(beta);
    document().commit_beta();
  }
  ASSERT_TRUE(until(is_settled));
  EXPECT_EQ(document().history().size(), 2u);
  EXPECT_EQ(document().beta(), 2);
  document().undo();
  ASSERT_TRUE(until(is_settled));
  EXPECT_EQ(document().beta(), 0.25);
  EXPECT_FALSE(document().history().back().enabled);
}

// Ten seconds by the window's clock. It, gRPC and the server wait longer for a silent peer.
TEST_F(WorkspaceService, EditsGoOnWhileTheLinkStallsForTenSeconds) {
  Link link(server_.address, {.delay = milliseconds(1)});
  ASSERT_TRUE(open_through(link.address()));
  link.stall(true);
  constexpr size_t kEdits = 40;
  for (size_t edits = 0; edits < kEdits; ++edits) {
    document().preview_beta(0.5);
    workspace_.update();
    document().commit_beta();
    workspace_.viewport.move({150.0 + double(edits % 100), 150});
    workspace_.update();
    EXPECT_EQ(document().unacknowledged(), edits + 1);
    clock_.put_forward(milliseconds(250));
  }
  EXPECT_EQ(document().link(), LinkState::kLive);
  link.stall(false);
  ASSERT_TRUE(until([&] { return document().is_settled(); }));
  EXPECT_EQ(owner_.history("work")->size(), kEdits);
}

TEST_F(WorkspaceService, ThePointerFindsWhatIsShownUnderItOriginalOrEdited) {
  ASSERT_TRUE(open_through(server_.address));
  document().curve().set_fidelity(5);
  document().commit_curve();
  document().preview_beta(0);
  document().commit_beta();
  ASSERT_TRUE(
      until([&] { return document().is_settled() && document().stats().frame.edits == 2; }));
  Viewport& viewport = workspace_.viewport;
  const auto looks_at = [&](const Eigen::Vector2d& pixel, auto place) {
    viewport.move(pixel);
    workspace_.update();
    if (!viewport.hover()) return false;
    const Vec3d found = (*viewport.hover()).*place;
    return (pixel_of(viewport.camera, viewport.size(), found) - pixel).norm() < 1;
  };
  const Eigen::Vector2d left(170, 120), right(230, 120);
  EXPECT_TRUE(looks_at(left, &SurfaceHit::displaced));
  EXPECT_FALSE(looks_at(left, &SurfaceHit::original));
  viewport.hold_original = true;  // the pointer does not move
  EXPECT_TRUE(looks_at(left, &SurfaceHit::original));
  viewport.hold_original = false;
  EXPECT_FALSE(looks_at(left, &SurfaceHit::original));
  viewport.options.split = true;
  EXPECT_TRUE(looks_at(left, &SurfaceHit::original));
  EXPECT_TRUE(looks_at(right, &SurfaceHit::displaced));
  EXPECT_FALSE(looks_at(right, &SurfaceHit::original));
}

TEST_F(WorkspaceService, APointerAtRestSeesTheSurfaceThatMovesUnderIt) {
  ASSERT_TRUE(open_through(server_.address));
  const Eigen::Vector2d pixel(230, 120), middle = pixel + Eigen::Vector2d(0.5, 0.5);
  workspace_.viewport.move(pixel);
  const auto ring_pixel = [&] {
    const Viewport& viewport = workspace_.viewport;
    return pixel_of(viewport.camera, viewport.size(), viewport.hover()->displaced);
  };
  ASSERT_TRUE(until([&] { return workspace_.viewport.hover().has_value(); }));
  const Vec3d before = workspace_.viewport.hover()->original;
  EXPECT_LT((ring_pixel() - middle).norm(), 0.1);
  document().curve().set_fidelity(5);
  document().commit_curve();
  document().preview_beta(0);
  document().commit_beta();
  ASSERT_TRUE(
      until([&] { return document().is_settled() && document().stats().frame.edits == 2; }));
  workspace_.update();  // looks under the pointer in the last picture
  ASSERT_TRUE(workspace_.viewport.hover().has_value());
  EXPECT_LT((ring_pixel() - middle).norm(), 0.1);
  EXPECT_GT((workspace_.viewport.hover()->original - before).norm(), 0.05);
}

}  // namespace
}  // namespace burnish

#include <algorithm>

#include <gtest/gtest.h>

#include "client/scene/null_page_renderer.h"
#include "common/base/text_lines.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/fast_clock.h"
#include "tests/system/link.h"
#include "tests/system/server_process.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{400, 300};
const Eigen::Vector2d kBall(200, 150);  // the ball's middle in the first picture

/// A workspace that keeps preferences, on a session over a ball.
class WorkspaceViews : public testing::Test {
 protected:
  WorkspaceViews() {
    EXPECT_TRUE(owner_.import_scan(write_sphere(server_.folder, 3), "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(owner_.open_session({"ball", "work", {5, 0}}).is_ok());
    EXPECT_TRUE(owner_.open_session({"ball", "other", {5, 0}}).is_ok());
    workspace_.viewport.set_size(kSize);
    viewport().clock = clock_.clock();
    workspace_.connect(server_.address);
  }

  bool open(const std::string& session) {
    workspace_.close_document();
    workspace_.when_connected([this, session] { workspace_.join_by_name(session); });
    return until([&] { return workspace_.document() && document().session().name == session; }) &&
           until_settled();
  }
  bool until_settled() {
    return until([this] { return document().is_settled() && document().is_picture_settled(); });
  }
  template <typename What>
  bool until(What what) {
    return pictures_until(workspace_, what);
  }

  Document& document() { return *workspace_.document(); }
  Viewport& viewport() { return workspace_.viewport; }

  void press_middle(const Eigen::Vector2d& pixel) {
    viewport().press(PointerButton::kMiddle, {}, pixel);
    viewport().release(PointerButton::kMiddle);
  }

  size_t enabled_entries() {
    EXPECT_TRUE(until_settled());
    return static_cast<size_t>(std::ranges::count_if(
        document().history(), [](const HistoryEntry& entry) { return entry.enabled; }));
  }

  ServerProcess server_;
  Connection owner_ = Connection::open(server_.address, kPatience).value();
  NullPageRenderer renderer_;
  FastClock clock_;
  Workspace workspace_{renderer_, Preferences(),
                       WorkspaceOptions{.preferences = server_.folder / "config/window.toml",
                                        .clock = clock_.clock()}};
};

TEST_F(WorkspaceViews, ASessionIsSeenAsItWasLeft) {
  ASSERT_TRUE(open("work"));
  viewport().set_up(UpAxis::kZ);
  viewport().camera.azimuth_degrees = 77;
  viewport().camera.orthographic = true;
  viewport().options.split = true;
  viewport().options.lighting.kind = LightKind::kCavity;
  viewport().options.curvature = {0.5, 2};
  viewport().add_bookmark();
  document().set_colour(ColourBy::kCurvature);
  workspace_.update();
  const Camera left = viewport().camera;
  ASSERT_TRUE(open("other"));
  EXPECT_EQ(viewport().camera.up, UpAxis::kZ) << "a scan's axis is said once";
  EXPECT_FALSE(viewport().camera.orthographic);
  EXPECT_TRUE(viewport().bookmarks.empty());
  viewport().options.split = false;
  viewport().options.curvature = {};
  viewport().options.lighting.kind = LightKind::kClay;
  ASSERT_TRUE(open("work"));
  EXPECT_EQ(viewport().camera.azimuth_degrees, 77);
  EXPECT_EQ(viewport().camera.distance, left.distance);
  EXPECT_EQ(viewport().camera.target, left.target);
  EXPECT_EQ(viewport().camera.up, UpAxis::kZ);
  EXPECT_TRUE(viewport().camera.orthographic);
  EXPECT_TRUE(viewport().options.split);
  EXPECT_EQ(viewport().options.curvature, (ColourEnds{0.5, 2}));
  EXPECT_EQ(viewport().options.lighting.kind, LightKind::kCavity);
  EXPECT_EQ(viewport().bookmarks.size(), 1u);
  EXPECT_EQ(document().colour(), ColourBy::kCurvature);
}

TEST_F(WorkspaceViews, LandStandsOnItsFeetAndThisIsSaid) {
  const auto file = server_.folder / "land.ply";
  TriangleMesh land = make_icosphere(3, 1);
  for (Vec3d& vertex : land.vertices) vertex = vertex.cwiseProduct(Vec3d(9000, 7000, 800));
  ASSERT_TRUE(write_mesh(land, file).is_ok());
  ASSERT_TRUE(owner_.import_scan(file, "land", {5, 0}, {}).is_ok());
  ASSERT_TRUE(owner_.open_session({"land", "survey", {5, 0}}).is_ok());
  ASSERT_TRUE(open("survey"));
  EXPECT_EQ(viewport().camera.up, UpAxis::kZ);
  EXPECT_TRUE(std::ranges::any_of(workspace_.log.messages(), [](const Message& message) {
    return message.text.find("z is up") != std::string::npos;
  }));
  viewport().set_up(UpAxis::kY);
  workspace_.update();
  ASSERT_TRUE(open("work"));
  ASSERT_TRUE(open("survey"));
  EXPECT_EQ(viewport().camera.up, UpAxis::kY) << "what the user says holds";
}

TEST_F(WorkspaceViews, ADoubleClickTurnsAboutThePointAndComesNearer) {
  ASSERT_TRUE(open("work"));
  const Eigen::Vector2d pixel = kBall + Eigen::Vector2d(40, -20);
  viewport().move(pixel);
  workspace_.update();
  ASSERT_TRUE(viewport().hover().has_value());
  const Vec3d point = viewport().hover()->displaced;
  const double distance = viewport().camera.distance;
  press_middle(pixel);
  workspace_.update();
  EXPECT_EQ(viewport().camera.distance, distance) << "one click does nothing";
  press_middle(pixel);
  workspace_.update();
  EXPECT_LT((viewport().camera.target - point).norm(), 1e-6);
  EXPECT_NEAR(viewport().camera.distance, distance / 2, 1e-9);
}

TEST_F(WorkspaceViews, WithoutPerspectiveThePointerFindsTheSurface) {
  ASSERT_TRUE(open("work"));
  viewport().camera.orthographic = true;
  viewport().move(kBall);
  workspace_.update();
  ASSERT_TRUE(viewport().hover().has_value());
  const Vec3d point = viewport().hover()->displaced;
  EXPECT_LT((pixel_of(viewport().camera, kSize, point) - kBall).norm(), 1);
  EXPECT_GT((point - document().box().center()).dot(camera_axes(viewport().camera).row(2)), 0);
}

TEST_F(WorkspaceViews, HomeResetsTheTilt) {
  ASSERT_TRUE(open("work"));
  const Camera first = viewport().camera;
  viewport().camera = turned(viewport().camera, 100, 50);
  viewport().go_home();
  workspace_.update();
  EXPECT_EQ(viewport().camera.azimuth_degrees, first.azimuth_degrees);
  EXPECT_EQ(viewport().camera.elevation_degrees, first.elevation_degrees);
}

TEST_F(WorkspaceViews, AClickOfTheRightButtonAsksForTheMenuOfThePointAndADragMoves) {
  ASSERT_TRUE(open("work"));
  const Camera before = viewport().camera;
  const auto press = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    viewport().move(from);
    workspace_.update();
    viewport().press(PointerButton::kRight, {}, from);
    viewport().move(to);
    workspace_.update();
    viewport().release(PointerButton::kRight);
    workspace_.update();
  };
  press(kBall, kBall + Eigen::Vector2d(2, 1));  // a hand trembles
  ASSERT_TRUE(viewport().menu.has_value());
  EXPECT_EQ(viewport().camera, before);
  ASSERT_TRUE(viewport().menu->point.has_value());
  const Vec3d point = *viewport().menu->point;
  viewport().leave();
  viewport().focus();
  EXPECT_EQ(viewport().camera.target, point);
  viewport().camera = before;
  press({3, 3}, {3, 3});
  ASSERT_TRUE(viewport().menu.has_value());
  EXPECT_FALSE(viewport().menu->point.has_value()) << "beside the ball";
  press(kBall, kBall + Eigen::Vector2d(40, 0));
  EXPECT_FALSE(viewport().menu.has_value());
  Camera moved = panned(before, kSize, Eigen::Vector2d(40, 0));
  EXPECT_LT((viewport().camera.target - moved.target).norm(), 1e-9 * before.distance);
}

TEST_F(WorkspaceViews, ADragWithControlAndShiftMovesTheLampAlone) {
  ASSERT_TRUE(open("work"));
  const Camera before = viewport().camera;
  const Eigen::Vector2d lamp = lamp_on_ball(viewport().options.lighting);
  viewport().press(PointerButton::kRight, {.shift = true, .control = true}, kBall);
  viewport().move(kBall + Eigen::Vector2d(40, 20));
  viewport().release(PointerButton::kRight);
  workspace_.update();
  EXPECT_EQ(viewport().camera, before);
  const Eigen::Vector2d moved = lamp_on_ball(viewport().options.lighting) - lamp;
  EXPECT_GT(moved.x(), 0.1);
  EXPECT_LT(moved.y(), -0.05);
}

TEST_F(WorkspaceViews, AStrokeAndItsMirrorImageAreOneStep) {
  ASSERT_TRUE(open("work"));
  document().mirror = MirrorPlane{0, document().box().center().x()};
  viewport().press(PointerButton::kLeft, {}, kBall);
  workspace_.update();
  viewport().release(PointerButton::kLeft);
  workspace_.update();
  EXPECT_EQ(enabled_entries(), 2u);
  document().mirror.reset();
  document().preview_beta(0.5);
  document().commit_beta();
  EXPECT_EQ(enabled_entries(), 3u);
  document().undo();
  document().undo();
  EXPECT_EQ(enabled_entries(), 0u);
  document().redo();
  EXPECT_EQ(enabled_entries(), 2u);
}

TEST_F(WorkspaceViews, ABrushBeginsConnectedWithTheValuesThatTheLastOneHad) {
  workspace_.preferences.brush_strength = 0.25;
  ASSERT_TRUE(open("work"));
  EXPECT_TRUE(document().brush().brush.connected);
  EXPECT_EQ(document().brush().brush.strength, 0.25);
}

TEST_F(WorkspaceViews, AMirroredStrokeIsRecordedAsTheStrokesOfBothSides) {
  ASSERT_TRUE(open("work"));
  const auto file = server_.folder / "record.txt";
  ASSERT_TRUE(workspace_.recorder.open(file).is_ok());
  document().mirror = MirrorPlane{1, 0.25};
  document().paint({{.radius = 0.5, .beta = 3, .connected = true}, {Vec3d(0, 1, 0)}});
  const std::string text = std::move(read_text_file(file)).value();
  EXPECT_EQ(text, "stroke 0.5 1 3 smooth 0 1 0\nstroke 0.5 1 3 smooth 0 -0.5 0\n");
  EXPECT_TRUE(until_settled());
}

}  // namespace
}  // namespace burnish

// The start page of a real window.

#include <algorithm>
#include <utility>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

class StartPageTest : public WindowTest {
 protected:
  bool has_session_at(int depth) {
    const auto sessions = connection_->list_sessions();
    return sessions.is_ok() && std::ranges::any_of(*sessions, [&](const SessionInfo& session) {
             return session.key.depth == depth;
           });
  }

  // Returns whether the start page says in green that it is connected.
  bool window_is_connected() {
    const Image image = screen_->capture();
    for (int x = 136; x < 320; ++x) {
      const uint8_t* rgb = image.pixel(x, 315);
      if (rgb[1] > 150 && rgb[0] < 140) return true;
    }
    return false;
  }
};

TEST_F(StartPageTest, FilesThatAreDroppedAreImportedAndTheFirstGoodOneIsOpened) {
  start_window({"--scale", "1"});
  ASSERT_TRUE(eventually([&] { return window_is_connected(); })) << window_->output();
  const auto letter = server_->folder.write("letter.txt", "Dear Sir");
  screen_->drop({letter, write_sphere(server_->folder, 3), write_sphere(server_->folder, 4)});
  EXPECT_TRUE(eventually([&] { return connection_->list_scans()->size() == 3; }));
  EXPECT_TRUE(eventually([&] { return is_surface(screen_->capture()); })) << window_->output();
  // The file's own surface is there before its session.
  EXPECT_TRUE(eventually([&] { return connection_->list_sessions()->size() == 2; }));
}

TEST_F(StartPageTest, AFileThatComesAgainGoesOnInItsSession) {
  const auto file = server_->folder / "blob.ply";
  start_window({file.string(), "--scale", "1"});
  ASSERT_TRUE(shows_session()) << window_->output();
  EXPECT_EQ(connection_->list_sessions()->size(), 1u);
  screen_->drag(kPictureX - 60, kPictureY, kPictureX + 60, kPictureY);
  EXPECT_EQ(newest_of(1).kind, EditKind::kStroke);
}

// The left button turns the raw scan. The picture of the session takes its place.
TEST_F(StartPageTest, AFileIsSeenBeforeItIsPreparedAndTheCameraStays) {
  const auto file = server_->folder / "large.ply";
  const auto mesh = generate_scan({.kind = "blob", .vertices = 500'000});
  ASSERT_TRUE(mesh.is_ok() && write_mesh(*mesh, file).is_ok());
  start_window({"--scale", "1"});
  ASSERT_TRUE(eventually([&] { return window_is_connected(); })) << window_->output();
  screen_->drop({file});
  ASSERT_TRUE(shows_surface()) << window_->output();
  EXPECT_EQ(screen_->title(), "large.ply – Burnish");
  const Image front = screen_->capture();
  save_screen("raw.png");
  screen_->drag(kPictureX, kPictureY, kPictureX + 200, kPictureY);
  Image turned = front;  // the last picture before the session's
  const auto until_the_session = [&] {
    Image now = screen_->capture();
    const bool is_raw = screen_->title() == "large.ply – Burnish";
    if (is_raw) turned = std::move(now);
    return !is_raw;
  };
  EXPECT_TRUE(eventually(until_the_session));
  EXPECT_GT(difference(front, turned), 1);
  ASSERT_TRUE(shows_session()) << window_->output();
  const Image session = settle();
  EXPECT_LT(difference(turned, session), 0.6 * difference(front, session));  // in finer detail
  EXPECT_TRUE(connection_->history("large")->empty());
}

TEST_F(StartPageTest, AFileOpensAtTheDepthThatIsChosenWhileItIsPrepared) {
  const auto file = server_->folder / "large.ply";
  const auto mesh = generate_scan({.kind = "blob", .vertices = 500'000});
  ASSERT_TRUE(mesh.is_ok() && write_mesh(*mesh, file).is_ok());
  start_window({file.string(), "--scale", "1"});
  click_on("Raw/Depth");
  places_->wait_for("Raw/Depth 6");
  save_screen("depths.png");
  click_on("Raw/Depth 6");
  ASSERT_TRUE(shows_session()) << window_->output();
  EXPECT_TRUE(has_session_at(6));
  click_on("Menu/File");
  click_on("Menu/Open again at depth");
  places_->wait_for("Menu/Depth 5");
  save_screen("depths-again.png");
  click_on("Menu/Depth 5");
  EXPECT_TRUE(eventually([this] { return has_session_at(5); }));
}

TEST_F(StartPageTest, SessionsAndScansCanBeDeleted) {
  constexpr int kDeleteX = 1110, kSessionY = 284, kScanY = 205, kSureX = 1128, kSureY = 37;
  start_window({"--scale", "1"});
  ASSERT_TRUE(eventually([&] { return window_is_connected(); })) << window_->output();
  save_screen("start.png");
  click(kDeleteX, kSessionY);
  save_screen("start-sure.png");
  click(kSureX, kSessionY + kSureY);
  EXPECT_TRUE(eventually([&] { return connection_->list_sessions()->empty(); }));
  EXPECT_EQ(connection_->list_scans()->size(), 1u);
  click(kDeleteX, kScanY);
  click(kSureX, kScanY + kSureY);
  EXPECT_TRUE(eventually([&] { return connection_->list_scans()->empty(); }));
}

}  // namespace
}  // namespace burnish

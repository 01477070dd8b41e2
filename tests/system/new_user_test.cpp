// The first job of a new user of a scanning lab, by the mouse alone but for one typed path.

#include <fstream>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/statistics/statistics.h"
#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr int kClicksMax = 12;

class NewUser : public WindowTest {
 protected:
  // Writes a tablet with an inscription, as a scanner with ripple would see it.
  std::filesystem::path write_noisy_scan() const {
    TriangleMesh mesh = generate_scan({.kind = "tablet", .vertices = 30'000}).value();
    std::mt19937 random(7);
    const double reach = 3e-4 * compute_statistics(mesh).diagonal();
    for (Vec3d& vertex : mesh.vertices)
      for (double& value : vertex) value += reach * (double(random()) / 2e9 - 1);
    const auto file = server_->folder / "noisy.ply";
    EXPECT_TRUE(write_mesh(mesh, file).is_ok());
    return file;
  }

  void click_once(const std::string& widget) {
    ++clicks_;
    click_on(widget);
  }
  // A drag is a click that lasts.
  void paint_once() {
    ++clicks_;
    screen_->drag(kPictureX - 80, kPictureY, kPictureX + 80, kPictureY);
  }
  std::vector<EditKind> kinds_of(const std::string& session) {
    std::vector<EditKind> kinds;
    const auto edits = connection_->history(session);
    for (size_t i = 0; edits.is_ok() && i < edits->size(); ++i) kinds.push_back((*edits)[i].kind);
    return kinds;
  }

  int clicks_ = 0;
};

TEST_F(NewUser, NeedsTwelveClicksAtMostFromANoisyScanToAnExportWithItsRecord) {
  const auto scan = write_noisy_scan();
  server_->folder.write("window.toml", "native_dialogs = false\n");
  start_window({"--scale", "1"});

  click_once("Start/Open a scan");
  places_->wait_for("Files/Typed");
  screen_->type(scan.string());
  save_screen("new-user-open.png");
  screen_->key({"Return"});
  ASSERT_TRUE(shows_session()) << window_->output();

  click_once("Filter/Presets");
  click_once("Filter/Reduce scanner noise");
  EXPECT_TRUE(eventually([&] { return kinds_of("noisy").size() == 2; }));
  const Image smooth = settle();

  click_once("Brush/Sharpen");
  paint_once();
  EXPECT_TRUE(eventually(
      [&] { return kinds_of("noisy").size() == 3 && kinds_of("noisy")[2] == EditKind::kStroke; }));
  EXPECT_TRUE(until_it_differs(smooth, 0.1));
  save_screen("new-user-inscription.png");

  const Image clay = settle();
  click_once("View/Colour");
  click_once("View/Displacement");
  EXPECT_TRUE(eventually([&] { return difference(clay, screen_->capture()) > 1; }));
  save_screen("new-user-deviation.png");

  click_once("Menu/File");
  click_once("Menu/Export…");
  click_once("Export/Export");
  const auto record = server_->folder / "noisy-edited-record.json";
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(record); })) << window_->output();

  EXPECT_LE(clicks_, kClicksMax);
  EXPECT_TRUE(read_mesh(server_->folder / "noisy-edited.ply").is_ok());
  const auto json = nlohmann::json::parse(std::ifstream(record));
  EXPECT_EQ(json["edits"].size(), 3u);
  EXPECT_GT(json["deviation"]["max"], 0.0);
  EXPECT_EQ(json["author"], "ada");
}

}  // namespace
}  // namespace burnish

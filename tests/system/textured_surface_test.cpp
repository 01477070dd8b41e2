// A scan with pictures as a window shows it: by a server that bakes its sheets.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/raster/raster_page_renderer.h"
#include "tests/server/prepare/sheets/photo_archive.h"
#include "tests/system/server_process.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

constexpr ImageSize kTexturedSize{320, 240};

/// A workspace that draws a session over a painted ball, without light.
class TexturedSurface : public testing::Test {
 protected:
  TexturedSurface() {
    import("ball", ball_.zip());
    workspace_.viewport.set_size(kTexturedSize);
    workspace_.viewport.options.lighting.kind = LightKind::kUnlit;
    workspace_.connect(server_.address);
  }

  void import(const std::string& name, const std::vector<uint8_t>& zip) {
    const std::filesystem::path file = server_.folder / (name + ".zip");
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(zip.data()), static_cast<std::streamsize>(zip.size()));
    const auto imported = owner_.import_scan(file, name, {5, 0}, {});
    EXPECT_TRUE(imported.is_ok()) << imported.status().to_string();
    EXPECT_TRUE(owner_.open_session({name, name + " session", {5, 0}}).is_ok());
  }

  bool open(const std::string& session) {
    workspace_.when_connected([this, session] { workspace_.join_by_name(session); });
    return pictures_until(workspace_, [&] { return workspace_.document() != nullptr; }) &&
           until_settled();
  }

  bool until_settled() {
    return pictures_until(
        workspace_, [this] { return document().is_settled() && document().is_picture_settled(); });
  }

  Document& document() { return *workspace_.document(); }

  /// Returns the part of the ball's pixels whose colour is the pattern's.
  double part_alike() {
    EXPECT_TRUE(workspace_.viewport.draw(renderer_, document()).is_ok());
    const Image image = renderer_.read_pixels().value();
    int alike = 0, all = 0;
    for (int y = 0; y < kTexturedSize.height; y += 2)
      for (int x = 0; x < kTexturedSize.width; x += 2) {
        const auto hit =
            document().surface().hit_at(workspace_.viewport.camera, kTexturedSize, {x, y}, false);
        if (!hit) continue;
        const Rgba8 pattern = ball_.colour_at(hit->original);
        bool is_alike = true;
        for (int c = 0; c < 3; ++c) is_alike &= std::abs(pattern[c] - image.pixel(x, y)[c]) < 20;
        alike += is_alike;
        ++all;
      }
    EXPECT_GT(all, 1000);
    return double(alike) / all;
  }

  const PaintedBall ball_ = {.quads_per_side = 8, .face_texels = 254};
  ServerProcess server_;
  Connection owner_ = Connection::open(server_.address, kPatience).value();
  RasterPageRenderer renderer_{1};
  Workspace workspace_{renderer_, Preferences(), WorkspaceOptions{}};
};

TEST_F(TexturedSurface, APictureShowsTheScansOwnOnceItIsSettled) {
  ASSERT_TRUE(open("ball session"));
  EXPECT_GT(part_alike(), 0.95);
  document().set_colour(ColourBy::kNothing);
  ASSERT_TRUE(until_settled());
  EXPECT_LT(part_alike(), 0.2);
}

TEST_F(TexturedSurface, TheTextureStaysWhereAnEditMovesTheSurface) {
  ASSERT_TRUE(open("ball session"));
  document().edit(SetGradientScale{3});
  ASSERT_TRUE(until_settled());
  EXPECT_GT(part_alike(), 0.93);
}

TEST_F(TexturedSurface, AScanWithoutPicturesKeepsTheColoursOfItsVertices) {
  const std::filesystem::path file = server_.folder / "plain.ply";
  std::ofstream(file) << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
                         "float y\nproperty float z\nproperty uchar red\nproperty uchar "
                         "green\nproperty uchar blue\nelement face 4\nproperty list uchar int "
                         "vertex_indices\nend_header\n0 0 0 200 10 10\n1 0 0 200 10 10\n0 1 0 200 "
                         "10 10\n0 0 1 200 10 11\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  ASSERT_TRUE(owner_.import_scan(file, "plain", {5, 0}, {}).is_ok());
  ASSERT_TRUE(owner_.open_session({"plain", "plain session", {5, 0}}).is_ok());
  ASSERT_TRUE(open("plain session"));
  ASSERT_TRUE(workspace_.viewport.draw(renderer_, document()).is_ok());
  const Image image = renderer_.read_pixels().value();
  bool has_red = false;
  for (size_t i = 0; i < image.rgb.size(); i += 3)
    has_red |= std::abs(image.rgb[i] - 200) <= 1 && std::abs(image.rgb[i + 1] - 10) <= 1;
  EXPECT_TRUE(has_red);
  for (const Message& message : workspace_.log.messages())
    EXPECT_EQ(message.text.find("texture"), std::string::npos) << message.text;
}

/// The same over photos of different exposure.
class LevelledView : public TexturedSurface {
 protected:
  LevelledView() { import("grid", zip_of(grid_)); }

  uint64_t version() { return document().surface().textures()->version(); }

  /// Returns the median step at the seams of the picture, levels of a byte.
  double step() {
    EXPECT_TRUE(workspace_.viewport.draw(renderer_, document()).is_ok());
    const Image image = renderer_.read_pixels().value();
    std::map<std::pair<int, int>, Vec3d> shown;  // by place, in tenths
    for (int y = 0; y < kTexturedSize.height; y += 3)
      for (int x = 0; x < kTexturedSize.width; ++x) {
        const auto hit =
            document().surface().hit_at(workspace_.viewport.camera, kTexturedSize, {x, y}, false);
        if (!hit) continue;
        const auto* pixel = image.pixel(x, y);
        shown[tenths(hit->original.x(), hit->original.y())] = Vec3d(pixel[0], pixel[1], pixel[2]);
      }
    std::vector<double> steps;
    for (int seam = grid_.cells; seam < grid_.side(); seam += grid_.cells)
      for (const auto& [place, colour] : shown) {
        if (place.first < 10 * seam - 2 || place.first >= 10 * seam) continue;
        for (const int across : {10 * seam, 10 * seam + 1})
          if (const auto other = shown.find({across, place.second}); other != shown.end())
            steps.push_back((colour - other->second).cwiseAbs().mean());
      }
    EXPECT_GT(steps.size(), 20u);
    std::ranges::sort(steps);
    return steps.empty() ? 0 : steps[steps.size() / 2];
  }

  const PhotoGrid grid_{.cells = 12, .texels = 92};

 private:
  static std::pair<int, int> tenths(double x, double y) {
    return {static_cast<int>(std::floor(10 * x)), static_cast<int>(std::floor(10 * y))};
  }
};

TEST_F(LevelledView, SeamsAreLevelInThePictureAndAsTheyWereAfterUndo) {
  ASSERT_TRUE(open("grid session"));
  EXPECT_EQ(version(), 0u);
  const double before = step();
  EXPECT_GT(before, 10);
  document().edit(SetTexture{{.level_seams = 1}});
  ASSERT_TRUE(until_settled());
  EXPECT_NE(version(), 0u);
  EXPECT_FALSE(document().levels_seams());
  EXPECT_LE(step(), 0.4 * before);
  document().undo();
  ASSERT_TRUE(until_settled());
  EXPECT_EQ(version(), 0u);
  EXPECT_NEAR(step(), before, 0.1);
  document().redo();
  ASSERT_TRUE(until_settled());
  EXPECT_LE(step(), 0.4 * before);
}

TEST_F(LevelledView, TheRegionAndTheNewestAmountCount) {
  ASSERT_TRUE(open("grid session"));
  for (const double amount : {0.2, 0.4, 0.6, 1.0})
    document().edit(SetTexture{{.level_seams = amount}});
  ASSERT_TRUE(until_settled());
  const auto newest = owner_.describe_sheets("grid", {}, "grid session");
  ASSERT_TRUE(newest.is_ok()) << newest.status().to_string();
  EXPECT_EQ(version(), newest->version);
  document().protect(left_half(grid_.side()));
  ASSERT_TRUE(until_settled());
  EXPECT_NE(version(), newest->version);
  EXPECT_EQ(version(), owner_.describe_sheets("grid", {}, "grid session")->version);
}

TEST_F(LevelledView, SomebodyWhoJoinsLaterSeesThemAndAClientThatComesBackTheNewest) {
  const Edit edit{"level", SetTexture{{.level_seams = 1}}};
  ASSERT_TRUE(owner_.apply("grid session", {&edit, 1}).is_ok());
  ASSERT_TRUE(open("grid session"));
  const uint64_t levelled = version();
  EXPECT_NE(levelled, 0u);
  server_.kill();
  ASSERT_TRUE(pictures_until(workspace_, [this] { return document().link() == LinkState::kLost; }));
  server_.listen = server_.address;
  server_.start();
  const Edit half{"half", SetTexture{{.level_seams = 0.5}}};
  Connection again = Connection::open(server_.address, kPatience).value();
  ASSERT_TRUE(again.apply("grid session", {&half, 1}).is_ok());
  ASSERT_TRUE(pictures_until(workspace_, [&] {
    return document().texture().level_seams == 0.5 && document().is_settled() &&
           document().is_picture_settled();
  }));
  EXPECT_NE(version(), levelled);
  EXPECT_EQ(version(), again.describe_sheets("grid", {}, "grid session")->version);
}

}  // namespace
}  // namespace burnish

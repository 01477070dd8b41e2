#include <gmock/gmock.h>

#include "common/archive/archive.h"
#include "tests/common/archive/packing.h"
#include "tests/common/mesh/rewrite/photo_grid.h"
#include "tests/common/mesh/rewrite/textured_grid.h"
#include "tests/system/filter_command.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// `burnish filter` on a square with a picture, whose colours are evened out.
class FilterTextures : public FilterCommand {
 protected:
  FilterTextures() {
    const TexturedGrid grid{.begin = 0.05, .end = 0.95};
    folder_.write("scan.obj", grid.obj());
    folder_.write("skin.mtl", kSkinMtl);
    folder_.write("skin.png", skin_);
    folder_.write("scan.glb", grid.glb(skin_).glb());
  }

  /// Returns what is printed as JSON.
  nlohmann::json evened(const std::string& in, const std::string& out,
                        const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"filter", path(in),        path(out), "--depth",
                                      "5",      "--colour-beta", "0",       "--colour-alpha",
                                      "5",      "--json"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(burnish(words), 0) << output_;
    const size_t begin = output_.find("{");
    return nlohmann::json::parse(output_.substr(begin)).at("files").at(0);
  }

  std::string content(const std::string& name) const { return content_of(folder_ / name); }

  const std::string skin_ = png_of(drawn(64, 64, [](uint32_t x, uint32_t) {
    return x < 32 ? Rgba8{60, 60, 60, 255} : Rgba8{190, 190, 190, 255};
  }));
};

TEST_F(FilterTextures, EditedColoursAreInThePictureBesideTheMeshAndInAnArchive) {
  const auto told = evened("scan.obj", "out.zip");
  EXPECT_EQ(told["pictures"]["changed"], 1);
  EXPECT_GT(told["pictures"]["texels"], 1000);
  EXPECT_TRUE(told["left_out"].empty());
  std::filesystem::create_directory(path("other"));
  evened("scan.obj", "other/scan.obj");
  EXPECT_NE(content("other/skin.png"), skin_);
  EXPECT_EQ(content("skin.png"), skin_);
  const std::string archive = content("out.zip");
  const Archive opened = std::move(Archive::open(as_bytes(archive), "out")).value();
  EXPECT_EQ(as_string(opened.read(opened.find("skin.png").value()).value()),
            content("other/skin.png"));
  std::filesystem::create_directory(path("third"));
  evened("out.zip", "third/scan.obj");
  EXPECT_NE(content("third/skin.png"), content("other/skin.png"));
}

TEST_F(FilterTextures, TrianglesWithoutAPictureKeepTheirColoursAndAreTold) {
  std::string obj = content("scan.obj");
  obj.insert(obj.rfind("\nf ", obj.rfind("\nf ") - 1) + 1, "usemtl bare\n");
  folder_.write("scan.obj", obj);
  const auto told = evened("scan.obj", "out.zip");
  EXPECT_EQ(told["pictures"]["changed"], 1);
  EXPECT_EQ(told["pictures"]["bare_triangles"], 2);
  EXPECT_EQ(told["left_out"].at(0), "edited colours of 2 triangles without a picture");
  EXPECT_THAT(output_, HasSubstr("out.zip: edited colours of 2 triangles without a picture\n"));
}

TEST_F(FilterTextures, TheScansOwnPictureIsReplacedByForceAlone) {
  const auto told = evened("scan.obj", "out.obj");
  EXPECT_THAT(told["left_out"].dump(), HasSubstr("edited colours"));
  EXPECT_EQ(content("skin.png"), skin_);
  evened("scan.obj", "out.obj", {"--force"});
  EXPECT_NE(content("skin.png"), skin_);
}

TEST_F(FilterTextures, APictureInsideAGlbChangesInIt) {
  const auto told = evened("scan.glb", "out.glb");
  EXPECT_EQ(told["pictures"]["changed"], 1);
  EXPECT_NE(content("out.glb"), content("scan.glb"));
}

Rgba8 texel(const Picture& picture, uint32_t x, uint32_t y) {
  return picture.pixels[size_t{y} * picture.width + x];
}

TEST_F(FilterTextures, APaintedTextureGainIsInThePictureUnderItAlone) {
  folder_.write("paint.txt", "brush 1.5 1 0 constant texture\n3 3 0\n");  // fades the middle
  std::filesystem::create_directory(path("faded"));
  ASSERT_EQ(burnish({"filter", path("scan.obj"), path("faded/scan.obj"), "--depth", "5",
                     "--beta-paint", path("paint.txt")}),
            0)
      << output_;
  EXPECT_EQ(content("faded/scan.obj"), content("scan.obj"));
  const Picture before = read_picture(as_bytes(skin_), "skin").value();
  const Picture after = read_picture(as_bytes(content("faded/skin.png")), "skin").value();
  const auto step = [](const Picture& picture) {
    return texel(picture, 33, 32)[0] - texel(picture, 30, 32)[0];
  };
  EXPECT_EQ(step(before), 130);
  EXPECT_LT(step(after), 65);
  for (const uint32_t far : {2U, 8U, 55U, 61U})
    EXPECT_EQ(texel(after, far, far), texel(before, far, far));
}

TEST_F(FilterTextures, SeamsOfPhotosAreLevelledInThePictureAndTold) {
  const PhotoGrid grid;
  folder_.write("scan.obj", grid.obj());
  folder_.write("skin.png", png_of(grid.picture()));
  std::filesystem::create_directory(path("level"));
  ASSERT_EQ(burnish({"filter", path("scan.obj"), path("level/scan.obj"), "--depth", "5",
                     "--level-seams", "1"}),
            0)
      << output_;
  EXPECT_THAT(output_, HasSubstr("seams of 9 charts levelled"));
  EXPECT_EQ(content("level/scan.obj"), content("scan.obj"));
  const Picture after = read_picture(as_bytes(content("level/skin.png")), "skin").value();
  EXPECT_LE(grid.median_step(after), 0.3 * grid.median_step(grid.picture()));
  ASSERT_EQ(burnish({"filter", path("scan.obj"), path("level.ply"), "--depth", "5", "--level-seams",
                     "1"}),
            0);
  EXPECT_THAT(output_, HasSubstr("levelled seams"));
}

TEST_F(FilterTextures, SeamsOfAScanWithoutPicturesAreRefusedBeforeTheWork) {
  folder_.write("bare.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  EXPECT_NE(burnish({"filter", path("bare.obj"), path("out.obj"), "--level-seams", "1"}), 0);
  EXPECT_THAT(output_, HasSubstr("no pictures whose seams could be levelled"));
}

}  // namespace
}  // namespace burnish

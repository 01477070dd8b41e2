#include "common/mesh/rewrite/pictures/edited_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/archive/archive.h"
#include "common/mesh/rewrite/rewrite.h"
#include "common/mesh/textures/shown_picture.h"
#include "common/picture/picture.h"
#include "tests/common/archive/packing.h"
#include "tests/common/mesh/rewrite/textured_grid.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A file that is written again with other colours.
struct Recoloured {
  std::string file;
  PictureReport report;
  Status status;
};

Recoloured recoloured(MeshFormat format, const std::string& content,
                      const std::function<void(TriangleMesh&)>& paint,
                      const FileBudget& budget = {}) {
  const TriangleMesh before = parsed(format, content);
  TriangleMesh after = before;
  paint(after);
  Recoloured result;
  OutputBuffer output([&](std::string_view piece) {
    result.file += piece;
    return Status::ok();
  });
  PictureWork pictures{budget, {}};
  result.status = rewrite_mesh(as_bytes(content), format, "scan",
                               {before.vertices, after, 0, before.colours}, output, &pictures);
  result.report = pictures.report;
  return result;
}

std::string entry(const std::string& archive, const std::string& name) {
  const Archive opened = std::move(Archive::open(as_bytes(archive), "scan")).value();
  return as_string(opened.read(opened.find(name).value()).value());
}

std::string obj_archive(const std::string& skin, const TexturedGrid& grid = {}) {
  return as_string(
      packed({{"a/skin.png", skin}, {"a/scan.obj", grid.obj()}, {"a/skin.mtl", kSkinMtl}}));
}

std::string ply_archive(const std::string& skin) {
  return as_string(packed({{"scan.ply", TexturedGrid().ply()}, {"skin.png", skin}}));
}

std::string gltf_archive(const std::string& skin) {
  GlbFile file = TexturedGrid().glb("nothing");
  file.json["images"] = {{{"uri", "skin.png"}}};
  return as_string(packed({{"scan.gltf", file.gltf()}, {"skin.png", skin}}));
}

std::string glb_with(const std::string& skin) {
  return TexturedGrid().glb(skin).glb();
}

void paint_nothing(TriangleMesh&) {}

/// Returns the part of the shown texels' channels that are within two levels in a picture.
double part_as_shown(MeshFormat format, const std::string& content, const Picture& before,
                     const Picture& after) {
  const TriangleMesh mesh = parsed(format, content);
  TriangleMesh painted = mesh;
  paint_right_side(painted);
  double shown = 0, near = 0;
  const auto take = [&](const TexturedSurface& surface) {
    for (uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) {
      auto corners = corners_on_picture(surface.textures, t);
      for (auto& corner : corners)
        corner = corner.cwiseProduct(Eigen::Vector2d(before.width, before.height));
      for (uint32_t y = 0; y < before.height; ++y)
        for (uint32_t x = 0; x < before.width; ++x) {
          const auto weights = weights_at(corners, {x + 0.5, y + 0.5});
          if (!weights) continue;
          for (size_t i = 0; i < 3; ++i) {
            double change = 0;
            for (int k = 0; k < 3; ++k) {
              const uint32_t v = mesh.triangles[t][k];
              change += (*weights)[k] * (light_of_level(painted.colours[v][i]) -
                                         light_of_level(mesh.colours[v][i]));
            }
            const double wanted = std::round(shown_channel(before.at(x, y)[i], change));
            ++shown;
            near += std::abs(after.at(x, y)[i] - wanted) <= 2 ? 1 : 0;
          }
        }
    }
    return Status::ok();
  };
  EXPECT_TRUE(read_textured_surface(as_bytes(content), format, "scan", take).is_ok());
  EXPECT_GT(shown, 9000);
  return near / shown;
}

Picture picture_in(const std::string& file) {
  return read_picture(as_bytes(file), "skin").value();
}

TEST(EditedPictures, AScanWithoutEditsComesBackByteForByte) {
  const std::string skin = png_of(grid_skin());
  for (const std::string& archive : {obj_archive(skin), ply_archive(skin), gltf_archive(skin)}) {
    const Recoloured same = recoloured(MeshFormat::kZip, archive, paint_nothing);
    EXPECT_EQ(same.file, archive);
    EXPECT_EQ(same.report.pictures, 0u);
  }
  EXPECT_EQ(recoloured(MeshFormat::kGlb, glb_with(skin), paint_nothing).file, glb_with(skin));
}

TEST(EditedPictures, EditedColoursAreInThePictureAsTheyWereShown) {
  const std::string png = png_of(grid_skin()), jpeg = jpeg_of(grid_skin(), {.sampling = 1});
  for (const std::string& skin : {png, jpeg})
    for (const std::string& archive : {obj_archive(skin), ply_archive(skin), gltf_archive(skin)}) {
      const Recoloured edited = recoloured(MeshFormat::kZip, archive, paint_right_side);
      ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
      EXPECT_EQ(edited.report.changed, 1u);
      const std::string name =
          archive.find("a/skin.png") < archive.size() ? "a/skin.png" : "skin.png";
      const Picture after = picture_in(entry(edited.file, name));
      EXPECT_GE(part_as_shown(MeshFormat::kZip, archive, picture_in(skin), after), 0.99);
    }
}

TEST(EditedPictures, OnlyThePictureOfAnArchiveChanges) {
  const std::string archive = obj_archive(png_of(grid_skin()));
  const Recoloured edited = recoloured(MeshFormat::kZip, archive, paint_right_side);
  for (const char* name : {"a/scan.obj", "a/skin.mtl"})
    EXPECT_EQ(entry(edited.file, name), entry(archive, name));
  EXPECT_GT(edited.report.texels, 2000u);
  EXPECT_THAT(edited.report.kept, IsEmpty());
  EXPECT_THAT(text_of(edited.report), HasSubstr("1 of 1 pictures changed"));
}

TEST(EditedPictures, EditedTrianglesWithoutAPictureAreCounted) {
  std::string obj = TexturedGrid().obj();
  obj.insert(obj.rfind("\nf ", obj.rfind("\nf ") - 1) + 1, "usemtl bare\n");
  const std::string archive = as_string(
      packed({{"skin.png", png_of(grid_skin())}, {"scan.obj", obj}, {"skin.mtl", kSkinMtl}}));
  const Recoloured edited = recoloured(MeshFormat::kZip, archive, paint_right_side);
  ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
  EXPECT_EQ(edited.report.changed, 1u);
  EXPECT_EQ(edited.report.bare_triangles, 2u);
  const Recoloured same = recoloured(MeshFormat::kZip, archive, paint_nothing);
  EXPECT_EQ(same.report.bare_triangles, 0u);
}

TEST(EditedPictures, APictureInAGlbGrowsAndWhatLiesBehindMoves) {
  // One colour packs to nothing; its edits do not.
  const Picture plain = drawn(120, 90, [](uint32_t x, uint32_t) {
    return x < 60 ? Rgba8{90, 140, 200, 255} : Rgba8{140, 90, 100, 255};
  });
  const std::string glb = glb_with(png_of(plain));
  const Recoloured edited = recoloured(MeshFormat::kGlb, glb, paint_right_side);
  ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
  EXPECT_GT(edited.file.size(), glb.size());
  const TriangleMesh before = parsed(MeshFormat::kGlb, glb),
                     after = parsed(MeshFormat::kGlb, edited.file);
  EXPECT_EQ(after.vertices, before.vertices);
  EXPECT_EQ(after.triangles, before.triangles);
  std::string skin;
  const auto take = [&](const TexturedSurface& surface) {
    skin = as_string(surface.textures.pictures.at(0).read().value());
    return Status::ok();
  };
  ASSERT_TRUE(read_textured_surface(as_bytes(edited.file), MeshFormat::kGlb, "scan", take).is_ok());
  EXPECT_GE(part_as_shown(MeshFormat::kGlb, glb, plain, picture_in(skin)), 0.99);
}

TEST(EditedPictures, APictureMayBeADataUri) {
  const std::string png = png_of(grid_skin());
  GlbFile file = TexturedGrid().glb("nothing");
  file.json["images"] = {{{"uri", "data:image/png;base64," + to_base64(as_bytes(png))}}};
  const std::string before =
      parsed(MeshFormat::kGltf, file.gltf()).colours.empty() ? "" : file.gltf();
  const Recoloured edited = recoloured(MeshFormat::kGltf, before, paint_right_side);
  ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
  EXPECT_EQ(edited.report.changed, 1u);
  EXPECT_THAT(edited.file, HasSubstr("data:image/png;base64,"));
  EXPECT_NE(parsed(MeshFormat::kGltf, edited.file).colours,
            parsed(MeshFormat::kGltf, before).colours);
}

TEST(EditedPictures, BytesThatTwoImagesShareAreNotOverwritten) {
  GlbFile file = TexturedGrid().glb(png_of(grid_skin()));
  file.json["images"].push_back(file.json["images"][0]);
  const Recoloured edited = recoloured(MeshFormat::kGlb, file.glb(), paint_right_side);
  ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
  EXPECT_THAT(edited.file, HasSubstr(png_of(grid_skin()))) << "the other image has it";
  EXPECT_EQ(edited.report.changed, 1u);
}

TEST(EditedPictures, APictureThatCannotBeWrittenStaysAndSaysWhy) {
  const std::string repeating = obj_archive(png_of(grid_skin()), {.end = 2.5});
  const Recoloured kept = recoloured(MeshFormat::kZip, repeating, paint_right_side);
  EXPECT_EQ(kept.file, repeating);
  EXPECT_THAT(kept.report.kept,
              ElementsAre(testing::AllOf(HasSubstr("a/skin.png"), HasSubstr("repeats"))));
  const std::string arithmetic = obj_archive(jpeg_of(grid_skin(), {.has_arithmetic_codes = true}));
  const Recoloured same = recoloured(MeshFormat::kZip, arithmetic, paint_right_side);
  EXPECT_EQ(same.file, arithmetic);
  EXPECT_THAT(same.report.kept, ElementsAre(HasSubstr("arithmetic")));
}

/// Two squares with a picture each; the second one is damaged, missing or not edited.
std::string two_skins(const std::string& second) {
  std::string ply = TexturedGrid().ply();
  const std::string mark = "comment TextureFile skin.png\n";
  ply.replace(ply.find(mark), mark.size(), mark + "comment TextureFile other.png\n");
  ply.replace(ply.find("vertex_indices"), 14, "vertex_indices\nproperty int texnumber");
  size_t faces = 0;
  std::string text;
  for (size_t at = 0; at < ply.size();) {
    const size_t end = ply.find('\n', at);
    std::string line = ply.substr(at, end - at);
    const bool is_face = line.starts_with("3 ") && line.find('.') == std::string::npos;
    if (is_face) line += faces++ % 2 == 0 ? " 0" : " 1";
    text += line + "\n";
    at = end + 1;
  }
  NamedTexts files = {{"scan.ply", text}, {"skin.png", png_of(grid_skin())}};
  if (!second.empty()) files.emplace_back("other.png", second);
  return as_string(packed(files));
}

TEST(EditedPictures, ADamagedPictureStaysWhileOthersChange) {
  const std::string damaged = png_of(grid_skin()).substr(0, 500);
  const std::string archive = two_skins(damaged);
  const Recoloured edited = recoloured(MeshFormat::kZip, archive, paint_right_side);
  ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
  EXPECT_EQ(edited.report.changed, 1u);
  EXPECT_THAT(edited.report.kept,
              ElementsAre(testing::AllOf(HasSubstr("other.png"), HasSubstr("ends early"))));
  EXPECT_EQ(entry(edited.file, "other.png"), damaged);
}

TEST(EditedPictures, AMissingPictureChangesNothing) {
  const Recoloured edited = recoloured(MeshFormat::kZip, two_skins(""), paint_right_side);
  ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
  EXPECT_EQ(edited.report.pictures, 1u);
  EXPECT_EQ(edited.report.changed, 1u);
}

TEST(EditedPictures, APictureOfUneditedTrianglesKeepsItsBytes) {
  const std::string jpeg = jpeg_of(grid_skin());
  const std::string archive = two_skins(jpeg);
  const auto paint_a_corner = [](TriangleMesh& mesh) { mesh.colours[6] = {250, 0, 0, 255}; };
  const Recoloured edited = recoloured(MeshFormat::kZip, archive, paint_a_corner);
  ASSERT_TRUE(edited.status.is_ok()) << edited.status.message();
  EXPECT_EQ(edited.report.pictures, 1u);
  EXPECT_EQ(entry(edited.file, "other.png"), jpeg);
}

TEST(EditedPictures, MemoryIsAskedForAndARefusalEndsTheExport) {
  const std::string archive = obj_archive(png_of(grid_skin()));
  uint64_t most = 0;
  const auto count = [&](uint64_t bytes) {
    most = std::max(most, bytes);
    return Status::ok();
  };
  EXPECT_TRUE(recoloured(MeshFormat::kZip, archive, paint_right_side, count).status.is_ok());
  EXPECT_GT(most, 120u * 90u * 3u);
  const auto refuse = [&](uint64_t bytes) {
    return bytes == most ? resource_exhausted("too much") : Status::ok();
  };
  EXPECT_EQ(recoloured(MeshFormat::kZip, archive, paint_right_side, refuse).status.code(),
            StatusCode::kResourceExhausted);
}

TEST(EditedPictures, ACancelEndsTheExport) {
  int asked = 0;
  const auto cancel_later = [&](uint64_t) {
    return ++asked > 4 ? cancelled("enough") : Status::ok();
  };
  const std::string archive = obj_archive(png_of(grid_skin()));
  EXPECT_EQ(recoloured(MeshFormat::kZip, archive, paint_right_side, cancel_later).status.code(),
            StatusCode::kCancelled);
}

}  // namespace
}  // namespace burnish

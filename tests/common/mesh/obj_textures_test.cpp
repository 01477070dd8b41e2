
#include <gmock/gmock.h>

#include "common/mesh/io/mesh_io.h"
#include "common/mesh/obj/obj_files.h"
#include "tests/common/mesh/rewrite/rewriting.h"
#include "tests/common/mesh/texture_reference.h"
#include "tests/common/mesh/textured_square.h"
#include "tests/common/picture/encoding.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

FilesInMemory square_files() {
  FilesInMemory beside;
  beside.files = {{"square.mtl", kSquareMtl}, {"skin.png", png_of(square_picture())}};
  return beside;
}

Result<TriangleMesh> read_beside(const std::string& obj, const FilesInMemory& beside) {
  return read_mesh({reinterpret_cast<const uint8_t*>(obj.data()), obj.size()}, MeshFormat::kObj,
                   "scan", {&beside, "square.obj"});
}

std::vector<Rgba8> colours_of(const std::string& obj, const FilesInMemory& beside) {
  const auto mesh = read_beside(obj, beside);
  EXPECT_TRUE(mesh.is_ok()) << mesh.status().message();
  return mesh.is_ok() ? mesh->colours : std::vector<Rgba8>();
}

/// Returns the means of a square whose texture coordinates are scaled, then moved.
std::vector<Rgba8> square_reference(const Eigen::Vector2d& scale, const Eigen::Vector2d& offset,
                                    const TextureWraps& wraps = {}) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  std::vector<ReferenceCorners> corners(2);
  for (size_t t = 0; t < 2; ++t)
    for (size_t k = 0; k < 3; ++k) {
      const Vec3d& vertex = mesh.vertices[mesh.triangles[t][k]];
      const Eigen::Vector2d uv = Eigen::Vector2d(0.25, 0.25) + 0.5 * vertex.head<2>();
      const Eigen::Vector2d moved = scale.cwiseProduct(uv) + offset;
      corners[t][k] = {moved.x(), 1 - moved.y()};
    }
  return reference_colours(mesh, corners, square_picture(), wraps);
}

TEST(ObjTextures, AVertexHasTheMeanOfWhatItOwns) {
  EXPECT_EQ(colours_of(kSquareObj, square_files()), square_colours());
  EXPECT_LE(largest_difference(square_colours(), square_reference({1, 1}, {0, 0})), 1);
}

TEST(ObjTextures, PolygonsAreFansAsInTheMesh) {
  const std::string obj = replaced(kSquareObj, "f 1/1 2/2 3/3\nf 1/1 3/3 4/4", "f 1/1 2/2 3/3 4/4");
  EXPECT_EQ(colours_of(obj, square_files()), square_colours());
}

TEST(ObjTextures, AFaceWithoutCoordinatesHasTheDiffuseColour) {
  const std::string obj = replaced(kSquareObj, "f 1/1 3/3 4/4", "f 1 3 4");
  EXPECT_EQ(colours_of(obj, square_files())[3], (Rgba8{128, 128, 128, 255}));
}

TEST(ObjTextures, VerticesThatAreRepeatedAtASeamHaveTheMeanOfBoth) {
  const std::string obj = replaced(replaced(kSquareObj, "v 0 0 0\n", "v 0 0 0\nv 0 0 0\nv 1 1 0\n"),
                                   "f 1/1 2/2 3/3\nf 1/1 3/3 4/4", "f 1/1 4/2 5/3\nf 2/1 3/3 6/4");
  const std::vector<Rgba8> whole = square_colours(), seam = colours_of(obj, square_files());
  EXPECT_THAT(seam, ElementsAre(whole[0], whole[0], whole[2], whole[1], whole[2], whole[3]));
}

TEST(ObjTextures, NegativeIndicesCountBack) {
  const std::string obj = replaced(replaced(kSquareObj, "f 1/1 2/2 3/3", "f -4/-4 -3/-3 -2/-2"),
                                   "f 1/1 3/3 4/4", "f -4/-4/-1 -2/-2 -1/-1");
  EXPECT_EQ(colours_of(obj, square_files()), square_colours());
}

TEST(ObjTextures, TheScansOwnColoursComeFirst) {
  const std::string obj = replaced(kSquareObj, "v 0 0 0\n", "v 0 0 0 1 0 0\n");
  EXPECT_EQ(colours_of(obj, square_files())[0], (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(colours_of(obj, square_files())[1], (Rgba8{255, 255, 255, 255}));
}

TEST(ObjTextures, AMaterialWithoutAPictureHasItsDiffuseColour) {
  FilesInMemory beside = square_files();
  beside.files["square.mtl"] = "newmtl skin\nKd 1 0 0\nnewmtl other\nKd 0 1 0\n";
  const std::string obj = replaced(kSquareObj, "f 1/1 3/3 4/4", "usemtl other\nf 1/1 3/3 4/4");
  const Rgba8 red = {255, 0, 0, 255};
  const Rgba8 both = {188, 188, 0, 255};
  EXPECT_THAT(colours_of(obj, beside), ElementsAre(both, red, both, Rgba8{0, 255, 0, 255}));
}

TEST(ObjTextures, OneColourForAllIsNone) {
  FilesInMemory beside = square_files();
  beside.files.erase("skin.png");
  EXPECT_TRUE(colours_of(kSquareObj, beside).empty());
  beside.files.erase("square.mtl");
  EXPECT_TRUE(colours_of(kSquareObj, beside).empty());
}

TEST(ObjTextures, OneMeanForAllIsKeptWhereThePictureHasDetail) {
  const auto square_of = [](const Rgba8& corner) {
    FilesInMemory beside = square_files();
    beside.files["skin.png"] = png_of(drawn(64, 64, [&](uint32_t x, uint32_t y) {
      return x + y == 0 ? corner : Rgba8{90, 80, 70, 255};
    }));
    return colours_of(kSquareObj, beside);
  };
  EXPECT_THAT(square_of({0, 0, 0, 255}),
              ElementsAre(Rgba8{90, 80, 70, 255}, Rgba8{90, 80, 70, 255}, Rgba8{90, 80, 70, 255},
                          Rgba8{90, 80, 70, 255}));
  EXPECT_TRUE(square_of({90, 80, 70, 255}).empty());
}

TEST(ObjTextures, ScaleOffsetAndClampMoveTheCoordinates) {
  FilesInMemory beside = square_files();
  constexpr TextureWraps kClamps = {TextureWrap::kClamp, TextureWrap::kClamp};
  beside.files["square.mtl"] = "newmtl skin\nmap_Kd -o 0.5 0 0 skin.png\n";
  EXPECT_LE(largest_difference(colours_of(kSquareObj, beside), square_reference({1, 1}, {0.5, 0})),
            1);
  beside.files["square.mtl"] = "newmtl skin\nmap_Kd -s 3 -2 1 -o 0.5 0.1 0 skin.png\n";
  EXPECT_LE(
      largest_difference(colours_of(kSquareObj, beside), square_reference({3, -2}, {0.5, 0.1})), 1);
  beside.files["square.mtl"] = "newmtl skin\nmap_Kd -clamp on -s 3 2 1 -o -0.5 0.1 0 skin.png\n";
  EXPECT_LE(largest_difference(colours_of(kSquareObj, beside),
                               square_reference({3, 2}, {-0.5, 0.1}, kClamps)),
            1);
}

TEST(ObjTextures, JpegsAreReadAndOtherKindsCountAsNone) {
  FilesInMemory beside = square_files();
  beside.files["skin.png"] = jpeg_of(drawn(64, 64, [](uint32_t x, uint32_t) {
    return x < 32 ? Rgba8{200, 0, 0, 255} : Rgba8{0, 0, 200, 255};
  }));
  const auto colours = colours_of(kSquareObj, beside);
  ASSERT_EQ(colours.size(), 4u);
  EXPECT_GT(colours[0][0], colours[0][2]);
  EXPECT_GT(colours[1][2], colours[1][0]);
  beside.files["skin.png"] = "GIF89a";
  EXPECT_TRUE(colours_of(kSquareObj, beside).empty());
}

TEST(ObjTextures, ADamagedPictureIsNamed) {
  FilesInMemory beside = square_files();
  beside.files["skin.png"].resize(50);
  EXPECT_THAT(read_beside(kSquareObj, beside).status().message(), HasSubstr("scan: skin.png: "));
}

TEST(ObjTextures, AFileOnDiskFindsItsTexturesInItsFolder) {
  const TemporaryFolder folder;
  for (const auto& [name, content] : square_files().files) folder.write(name, content);
  EXPECT_EQ(read_mesh(folder.write("a.obj", kSquareObj)).value().colours, square_colours());
}

TEST(ObjFiles, FoundAndMissingFilesAreListedOnce) {
  FilesInMemory beside = square_files();
  beside.files["square.mtl"] += "map_Ks gone.png\nbump gone.png\nnewmtl b\nmap_Kd skin.png\n";
  const std::string obj = "mtllib square.mtl none.mtl\n" + kSquareObj;
  const auto files = find_obj_files({reinterpret_cast<const uint8_t*>(obj.data()), obj.size()},
                                    {&beside, "square.obj"});
  EXPECT_THAT(files.value().found, ElementsAre("square.mtl", "skin.png"));
  EXPECT_THAT(files.value().missing, ElementsAre("gone.png", "none.mtl"));
}

}  // namespace
}  // namespace burnish

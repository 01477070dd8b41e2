#include <gmock/gmock.h>

#include "common/mesh/io/mesh_io.h"
#include "tests/common/mesh/reading.h"
#include "tests/common/mesh/rewrite/rewriting.h"
#include "tests/common/mesh/texture_reference.h"
#include "tests/common/mesh/textured_square.h"
#include "tests/common/picture/encoding.h"

namespace burnish {
namespace {

using testing::ElementsAre;

constexpr Rgba8 kTextureRed = {200, 0, 0, 255}, kTextureBlue = {0, 0, 250, 255};

Picture plain_picture(const Rgba8& colour) {
  return drawn(3, 2, [&](uint32_t, uint32_t) { return colour; });
}

FilesInMemory ply_pictures() {
  FilesInMemory beside;
  beside.files = {{"skin.png", png_of(square_picture())},
                  {"red.png", png_of(plain_picture(kTextureRed))},
                  {"blue.png", png_of(plain_picture(kTextureBlue))}};
  return beside;
}

std::vector<Rgba8> ply_colours(const std::string& ply,
                               const FilesInMemory& beside = ply_pictures()) {
  const auto mesh = read_mesh({reinterpret_cast<const uint8_t*>(ply.data()), ply.size()},
                              MeshFormat::kPly, "scan", {&beside, "scan.ply"});
  EXPECT_TRUE(mesh.is_ok()) << mesh.status().message();
  return mesh.is_ok() ? mesh->colours : std::vector<Rgba8>();
}

/// The square of kSquareObj with a texture coordinate at each corner of its faces.
const std::string kWedgePly =
    "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 4\n"
    "property float x\nproperty float y\nproperty float z\nelement face 2\n"
    "property list uchar float texcoord\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "6 0.25 0.25 0.75 0.25 0.75 0.75 3 0 1 2\n6 0.25 0.25 0.75 0.75 0.25 0.75 3 0 2 3\n";

/// The same with a coordinate at each vertex.
std::string ply_of_vertices(const std::string& u, const std::string& v) {
  return "ply\nformat ascii 1.0\ncomment TEXTUREFILE skin.png\nelement vertex 4\n"
         "property float x\nproperty float y\nproperty float z\nproperty float " +
         u + "\nproperty float " + v +
         "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0 0.25 0.25\n1 0 0 0.75 0.25\n1 1 0 0.75 0.75\n0 1 0 0.25 0.75\n4 0 1 2 3\n";
}

TEST(PlyTextures, CoordinatesOfFacesGiveTheColoursOfAnObj) {
  EXPECT_EQ(ply_colours(kWedgePly), square_colours());
}

TEST(PlyTextures, CoordinatesOfVerticesHaveThreeNames) {
  EXPECT_EQ(ply_colours(ply_of_vertices("s", "t")), square_colours());
  EXPECT_EQ(ply_colours(ply_of_vertices("u", "v")), square_colours());
  EXPECT_EQ(ply_colours(ply_of_vertices("texture_u", "texture_v")), square_colours());
}

TEST(PlyTextures, StripsHaveTheCoordinatesOfVertices) {
  const std::string ply =
      replaced(replaced(ply_of_vertices("s", "t"), "element face", "element tristrips"),
               "4 0 1 2 3\n", "4 1 2 0 3\n");
  EXPECT_LE(largest_difference(ply_colours(ply), square_colours()), 1);
}

TEST(PlyTextures, BinaryBodiesAreReadToo) {
  std::string ply = replaced(ply_of_vertices("s", "t"), "ascii", "binary_little_endian");
  ply.resize(ply.find("end_header\n") + 11);
  for (const float x : {0.F, 0.F, 0.F, .25F, .25F, 1.F, 0.F, 0.F, .75F, .25F,  //
                        1.F, 1.F, 0.F, .75F, .75F, 0.F, 1.F, 0.F, .25F, .75F})
    ply += bytes_of(x);
  ply += bytes_of(uint8_t{4}, 0, 1, 2, 3);
  EXPECT_EQ(ply_colours(ply), square_colours());
}

TEST(PlyTextures, TexnumberChoosesAmongThePictures) {
  std::string ply = replaced(kWedgePly, "comment TextureFile skin.png\n",
                             "comment TextureFile red.png\ncomment TextureFile gone.png\n"
                             "comment TextureFile blue.png\n");
  ply = replaced(ply, "vertex_indices\nend", "vertex_indices\nproperty int texnumber\nend");
  const auto numbered = [&](const char* first, const char* second) {
    return ply_colours(replaced(replaced(ply, "3 0 1 2\n", "3 0 1 2 " + std::string(first) + "\n"),
                                "3 0 2 3\n", "3 0 2 3 " + std::string(second) + "\n"));
  };
  EXPECT_EQ(numbered("0", "2")[1], kTextureRed);
  EXPECT_EQ(numbered("0", "2")[3], kTextureBlue);
  const Rgba8 white = {255, 255, 255, 255};
  EXPECT_EQ(numbered("0", "1")[3], white);  // its file is missing
  EXPECT_EQ(numbered("0", "7")[3], white);
  EXPECT_EQ(numbered("0", "-1")[3], white);
}

TEST(PlyTextures, AFaceWithTooFewCoordinatesIsWhite) {
  const std::string ply = replaced(kWedgePly, "6 0.25 0.25 0.75 0.75 0.25 0.75", "2 0.25 0.25");
  EXPECT_EQ(ply_colours(ply)[3], (Rgba8{255, 255, 255, 255}));
}

TEST(PlyTextures, WithoutPicturesOrWithADamagedOneTheScanIsReadAsItIs) {
  EXPECT_TRUE(ply_colours(kWedgePly, FilesInMemory()).empty());
  FilesInMemory beside = ply_pictures();
  beside.files["skin.png"].resize(30);
  EXPECT_TRUE(ply_colours(kWedgePly, beside).empty());
  beside.files["skin.png"] = "GIF89a";
  EXPECT_TRUE(ply_colours(kWedgePly, beside).empty());
}

TEST(PlyTextures, TheScansOwnColoursComeFirst) {
  std::string ply = replaced(kWedgePly, "property float z\n",
                             "property float z\nproperty uchar red\nproperty uchar green\n"
                             "property uchar blue\n");
  ply = replaced(ply, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n",
                 "0 0 0 1 2 3\n1 0 0 4 5 6\n1 1 0 7 8 9\n0 1 0 1 1 1\n");
  EXPECT_THAT(ply_colours(ply), ElementsAre(Rgba8{1, 2, 3, 255}, Rgba8{4, 5, 6, 255},
                                            Rgba8{7, 8, 9, 255}, Rgba8{1, 1, 1, 255}));
}

}  // namespace
}  // namespace burnish


#include <gmock/gmock.h>

#include "common/mesh/obj_files.h"
#include "tests/common/mesh/rewrite/rewriting.h"
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

TEST(ObjColours, AVertexHasThePicturesColourAtItsFirstCoordinate) {
  EXPECT_EQ(colours_of(kSquareObj, square_files()), square_colours());
  const std::string again = kSquareObj + "f 1/3 2/3 4/3\n";
  EXPECT_EQ(colours_of(again, square_files()), square_colours());
}

TEST(ObjColours, NegativeIndicesCountBack) {
  const std::string obj = replaced(replaced(kSquareObj, "f 1/1 2/2 3/3", "f -4/-4 -3/-3 -2/-2"),
                                   "f 1/1 3/3 4/4", "f -4/-4/-1 -2/-2 -1/-1");
  EXPECT_EQ(colours_of(obj, square_files()), square_colours());
}

TEST(ObjColours, TheScansOwnColoursComeFirst) {
  const std::string obj = replaced(kSquareObj, "v 0 0 0\n", "v 0 0 0 1 0 0\n");
  EXPECT_EQ(colours_of(obj, square_files())[0], (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(colours_of(obj, square_files())[1], (Rgba8{255, 255, 255, 255}));
}

TEST(ObjColours, AMaterialWithoutAPictureHasItsDiffuseColour) {
  FilesInMemory beside = square_files();
  beside.files["square.mtl"] = "newmtl skin\nKd 1 0 0\nnewmtl other\nKd 0 1 0\n";
  const std::string obj = replaced(kSquareObj, "f 1/1 3/3 4/4", "usemtl other\nf 1/1 3/3 4/4");
  const Rgba8 red = {255, 0, 0, 255};
  EXPECT_THAT(colours_of(obj, beside), ElementsAre(red, red, red, Rgba8{0, 255, 0, 255}));
}

TEST(ObjColours, OneColourForAllIsNone) {
  FilesInMemory beside = square_files();
  beside.files.erase("skin.png");
  EXPECT_TRUE(colours_of(kSquareObj, beside).empty());
  beside.files.erase("square.mtl");
  EXPECT_TRUE(colours_of(kSquareObj, beside).empty());
}

TEST(ObjColours, ScaleAndOffsetMoveTheCoordinates) {
  FilesInMemory beside = square_files();
  beside.files["square.mtl"] = "newmtl skin\nmap_Kd -s 1 1 1 -o 0.5 0 0 skin.png\n";
  const auto turned = square_colours();
  EXPECT_THAT(colours_of(kSquareObj, beside),
              ElementsAre(turned[1], turned[0], turned[3], turned[2]));
}

TEST(ObjColours, JpegsAreReadAndOtherKindsCountAsNone) {
  FilesInMemory beside = square_files();
  beside.files["skin.png"] = jpeg_of(drawn(64, 64, [](uint32_t x, uint32_t) {
    return x < 32 ? Rgba8{200, 0, 0, 255} : Rgba8{0, 0, 200, 255};
  }));
  const auto colours = colours_of(kSquareObj, beside);
  ASSERT_EQ(colours.size(), 4u);
  EXPECT_NEAR(colours[0][0], 200, 4);
  EXPECT_NEAR(colours[1][2], 200, 4);
  beside.files["skin.png"] = "GIF89a";
  EXPECT_TRUE(colours_of(kSquareObj, beside).empty());
}

TEST(ObjColours, ADamagedPictureIsNamed) {
  FilesInMemory beside = square_files();
  beside.files["skin.png"].resize(50);
  EXPECT_THAT(read_beside(kSquareObj, beside).status().message(), HasSubstr("scan: skin.png: "));
}

TEST(ObjColours, AFileOnDiskFindsItsTexturesInItsFolder) {
  const TemporaryFolder folder;
  for (const auto& [name, content] : square_files().files) folder.write(name, content);
  EXPECT_EQ(read_mesh(folder.write("a.obj", kSquareObj)).value().colours, square_colours());
}

TEST(ObjFiles, FoundAndMissingFilesAreListedOnce) {
  FilesInMemory beside = square_files();
  beside.files["square.mtl"] += "map_Ks gone.png\nbump gone.png\nnewmtl b\nmap_Kd skin.png\n";
  const std::string obj = "mtllib square.mtl none.mtl\n" + kSquareObj;
  const auto files = find_obj_files({reinterpret_cast<const uint8_t*>(obj.data()), obj.size()},
                                    "square.obj", beside);
  EXPECT_THAT(files.value().found, ElementsAre("square.mtl", "skin.png"));
  EXPECT_THAT(files.value().missing, ElementsAre("gone.png", "none.mtl"));
}

}  // namespace
}  // namespace burnish

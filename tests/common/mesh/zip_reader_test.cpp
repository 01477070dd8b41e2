#include <gmock/gmock.h>

#include "common/mesh/io/mesh_io.h"
#include "tests/common/archive/packing.h"
#include "tests/common/mesh/reading.h"
#include "tests/common/mesh/textured_square.h"
#include "tests/common/picture/encoding.h"

namespace burnish {
namespace {

using testing::HasSubstr;

const std::string kPlainObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(ZipReader, TheOneMeshIsReadWhereverItLies) {
  const NamedTexts files = {{"readme.txt", "hello"}, {"deep/down/scan.OBJ", kPlainObj}};
  EXPECT_EQ(parsed(MeshFormat::kZip, as_string(packed(files))).vertices.size(), 3u);
}

TEST(ZipReader, TexturesInTheArchiveBecomeColours) {
  const std::string picture = png_of(square_picture());
  const NamedTexts files = {
      {"a/SKIN.PNG", picture}, {"a/square.obj", kSquareObj}, {"a/square.mtl", kSquareMtl}};
  EXPECT_EQ(parsed(MeshFormat::kZip, as_string(packed(files))).colours, square_colours());
}

TEST(ZipReader, APicturesMemoryIsAskedForAndARefusalNamesItAndItsSize) {
  const NamedTexts files = {{"skin.png", png_of(square_picture())},
                            {"square.obj", kSquareObj},
                            {"square.mtl", kSquareMtl}};
  const std::string zip = as_string(packed(files));
  const auto refuse = [](uint64_t bytes) {
    if (bytes == 0) return Status::ok();
    return resource_exhausted(std::to_string(bytes) + " bytes are too many");
  };
  const auto read = read_stored_mesh({reinterpret_cast<const uint8_t*>(zip.data()), zip.size()},
                                     MeshFormat::kZip, "scan", ScratchSpace(), refuse);
  EXPECT_EQ(read.status().code(), StatusCode::kResourceExhausted);
  const std::string sides =
      std::to_string(square_picture().width) + "x" + std::to_string(square_picture().height);
  EXPECT_THAT(read.status().message(), HasSubstr("skin.png: picture of " + sides + " pixels"));
}

TEST(ZipReader, ACancelIsHeardInAPicture) {
  const NamedTexts files = {{"skin.png", png_of(square_picture())},
                            {"square.obj", kSquareObj},
                            {"square.mtl", kSquareMtl}};
  const std::string zip = as_string(packed(files));
  bool has_begun = false;
  const auto cancel = [&](uint64_t bytes) {
    has_begun |= bytes > 0;
    return has_begun && bytes == 0 ? cancelled("between two rows") : Status::ok();
  };
  const auto read = read_stored_mesh({reinterpret_cast<const uint8_t*>(zip.data()), zip.size()},
                                     MeshFormat::kZip, "scan", ScratchSpace(), cancel);
  EXPECT_EQ(read.status().code(), StatusCode::kCancelled);
  EXPECT_THAT(read.status().message(), HasSubstr("skin.png"));
}

TEST(ZipReader, PicturesBesideTheObjsFolderAreFound) {
  const NamedTexts files = {{"textures/skin.png", png_of(square_picture())},
                            {"source/square.obj", kSquareObj},
                            {"source/square.mtl", "newmtl skin\nmap_Kd ../textures/skin.png\n"}};
  EXPECT_EQ(parsed(MeshFormat::kZip, as_string(packed(files))).colours, square_colours());
}

TEST(ZipReader, NotesOfMacOsAreNotMeshes) {
  const NamedTexts files = {
      {"scan.obj", kPlainObj}, {"__MACOSX/._scan.obj", "x"}, {"sub/._scan.obj", "x"}};
  EXPECT_EQ(parsed(MeshFormat::kZip, as_string(packed(files))).vertices.size(), 3u);
}

TEST(ZipReader, NoneOrTwoMeshesAreRefusedByName) {
  const std::string none = as_string(packed({{"a.txt", "x"}, {"b.zip", "y"}}));
  EXPECT_THAT(refusal(MeshFormat::kZip, none), HasSubstr("none of its 2 entries"));
  const std::string two = as_string(packed({{"a.obj", kPlainObj}, {"b.stl", "y"}}));
  EXPECT_THAT(refusal(MeshFormat::kZip, two), HasSubstr("'a.obj' and 'b.stl'"));
}

TEST(ZipReader, ComplaintsNameTheArchiveAndTheMesh) {
  EXPECT_THAT(refusal(MeshFormat::kZip, as_string(packed({{"a.obj", "v 0 0\n"}}))),
              HasSubstr("scan: a.obj: line 1"));
  EXPECT_THAT(refusal(MeshFormat::kZip, "PK\x03\x04 nonsense"), HasSubstr("scan: "));
}

}  // namespace
}  // namespace burnish

#include "common/bundle/scan_bundle.h"

#include <gmock/gmock.h>

#include "common/archive/archive.h"
#include "tests/common/archive/packing.h"
#include "tests/common/bundle/textured_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ScanBundle, AnObjIsPackedWithTheFilesThatItNames) {
  const TexturedFolder folder;
  const auto bundle = ScanBundle::open(folder / "scan.obj");
  ASSERT_TRUE(bundle.is_ok()) << bundle.status().message();
  EXPECT_EQ(bundle->format(), MeshFormat::kZip);
  EXPECT_THAT(bundle->beside(), ElementsAre("scan.mtl", "maps/skin.gif", "shine.gif"));
  EXPECT_THAT(bundle->missing(), ElementsAre("gone.png"));
  const Archive archive = std::move(Archive::open(bundle->bytes(), "bundle")).value();
  ASSERT_EQ(archive.entries().size(), 4u);
  for (size_t e = 0; e < 4; ++e)
    EXPECT_EQ(as_string(archive.read(e).value()), content_of(folder / archive.entries()[e].name));
  EXPECT_EQ(archive.entries()[0].name, "scan.obj");
}

TEST(ScanBundle, TheFolderGivesTheSameBytesAsItsMesh) {
  const TexturedFolder folder;
  const auto of_file = ScanBundle::open(folder / "scan.obj");
  const auto of_folder = ScanBundle::open(folder / "");
  ASSERT_TRUE(of_folder.is_ok()) << of_folder.status().message();
  EXPECT_EQ(of_folder->mesh().filename(), "scan.obj");
  EXPECT_TRUE(std::equal(of_file->bytes().begin(), of_file->bytes().end(),
                         of_folder->bytes().begin(), of_folder->bytes().end()));
}

TEST(ScanBundle, AMeshAloneIsSentAsItIs) {
  const TemporaryFolder folder;
  const auto bundle = ScanBundle::open(folder.write("scan.obj", kBundledObj));
  EXPECT_EQ(bundle->format(), MeshFormat::kObj);
  EXPECT_EQ(bundle->bytes().size(), kBundledObj.size());
  EXPECT_THAT(bundle->missing(), ElementsAre("scan.mtl"));
}

TEST(ScanBundle, AnArchiveThatLacksAFileSaysSo) {
  const TemporaryFolder folder;
  const auto packed_as = [&](const NamedTexts& files) {
    return ScanBundle::open(folder.write("scan.zip", as_string(packed(files))));
  };
  const auto bundle = packed_as({{"in/scan.obj", kBundledObj}});
  ASSERT_TRUE(bundle.is_ok()) << bundle.status().message();
  EXPECT_EQ(bundle->format(), MeshFormat::kZip);
  EXPECT_THAT(bundle->beside(), testing::IsEmpty());
  EXPECT_THAT(bundle->missing(), ElementsAre("scan.mtl"));
  EXPECT_THAT(packed_as({{"scan.obj", kBundledObj}, {"scan.mtl", "newmtl skin\n"}})->missing(),
              testing::IsEmpty());
  EXPECT_TRUE(ScanBundle::open(folder.write("scan.zip", "PK")).is_ok());  // a reader says why not
}

TEST(ScanBundle, AFolderMustHaveOneMesh) {
  const TemporaryFolder folder;
  EXPECT_THAT(ScanBundle::open(folder / "").status().message(), HasSubstr("no mesh file"));
  folder.write("b.obj", kBundledObj);
  folder.write("a.stl", "x");
  EXPECT_THAT(ScanBundle::open(folder / "").status().message(), HasSubstr("a.stl and b.obj"));
}

TEST(ScanBundle, FilesOutsideTheFolderAreNotPacked) {
  const TexturedFolder folder;
  std::filesystem::create_directory(folder / "inner");
  folder.write("inner/scan.obj", "mtllib ../scan.mtl\n" + kBundledObj);
  const auto bundle = ScanBundle::open(folder / "inner/scan.obj");
  EXPECT_EQ(bundle->format(), MeshFormat::kObj);
  EXPECT_THAT(bundle->missing(), ElementsAre("../scan.mtl", "scan.mtl"));
}

TEST(ScanBundle, APlyIsPackedWithThePictureThatItsCommentNames) {
  const TemporaryFolder folder;
  folder.write("my skin.png", "skin");
  const std::string ply =
      "ply\nformat ascii 1.0\ncomment TextureFile my skin.png\ncomment TextureFile gone.png\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto bundle = ScanBundle::open(folder.write("scan.ply", ply));
  ASSERT_TRUE(bundle.is_ok()) << bundle.status().message();
  EXPECT_EQ(bundle->format(), MeshFormat::kZip);
  EXPECT_THAT(bundle->beside(), ElementsAre("my skin.png"));
  EXPECT_THAT(bundle->missing(), ElementsAre("gone.png"));
}

TEST(ScanBundle, APlyIsPackedWithThePictureThatCloudCompareNamesInCapitals) {
  const TemporaryFolder folder;
  folder.write("skin.png", "skin");
  const std::string ply =
      "ply\nformat ascii 1.0\ncomment TEXTUREFILE skin.png\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto bundle = ScanBundle::open(folder.write("scan.ply", ply));
  ASSERT_TRUE(bundle.is_ok()) << bundle.status().message();
  EXPECT_THAT(bundle->beside(), ElementsAre("skin.png"));
}

}  // namespace
}  // namespace burnish

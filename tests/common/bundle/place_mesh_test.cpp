#include "common/bundle/place_mesh.h"

#include <gmock/gmock.h>

#include "tests/common/archive/packing.h"
#include "tests/common/bundle/textured_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// An archive with a file outside the mesh's folder.
class PlacedArchive : public testing::Test {
 protected:
  PlacedArchive() : mesh_(find_mesh(archive_).value()) {}

  const std::vector<uint8_t> bytes_ = packed({{"in/scan.obj", kBundledObj},
                                              {"in/scan.mtl", "newmtl a\n"},
                                              {"in/maps/skin.png", "skin"},
                                              {"readme.txt", "hello"}});
  const Archive archive_ = std::move(Archive::open(bytes_, "a.zip")).value();
  const ArchivedMesh mesh_;
  const TemporaryFolder folder_;
};

TEST_F(PlacedArchive, FilesLieBesideTheMeshUnderTheirNames) {
  const auto placed = place_mesh(archive_, mesh_, folder_ / "out.obj", false);
  ASSERT_TRUE(placed.is_ok()) << placed.status().message();
  EXPECT_EQ(content_of(folder_ / "out.obj"), kBundledObj);
  EXPECT_EQ(content_of(folder_ / "scan.mtl"), "newmtl a\n");
  EXPECT_EQ(content_of(folder_ / "maps/skin.png"), "skin");
  EXPECT_THAT(placed->left_out, ElementsAre("readme.txt"));
}

TEST_F(PlacedArchive, AFolderTakesTheWholeArchive) {
  const auto placed = place_archive(archive_, mesh_, folder_ / "new", false);
  ASSERT_TRUE(placed.is_ok()) << placed.status().message();
  EXPECT_EQ(placed->mesh, folder_ / "new/in/scan.obj");
  EXPECT_EQ(content_of(folder_ / "new/in/maps/skin.png"), "skin");
  EXPECT_EQ(content_of(folder_ / "new/readme.txt"), "hello");
}

TEST(HiddenEntries, StayInTheArchive) {
  const std::vector<uint8_t> bytes =
      packed({{"scan.obj", kBundledObj}, {".profile", "echo"}, {"maps/.git/hook", "echo"}});
  const Archive archive = std::move(Archive::open(bytes, "a.zip")).value();
  const ArchivedMesh mesh = find_mesh(archive).value();
  const TemporaryFolder folder;
  const auto placed = place_archive(archive, mesh, folder / "new", false);
  ASSERT_TRUE(placed.is_ok()) << placed.status().message();
  EXPECT_THAT(placed->left_out, ElementsAre(".profile", "maps/.git/hook"));
  EXPECT_FALSE(std::filesystem::exists(folder / "new/.profile"));
  EXPECT_THAT(place_mesh(archive, mesh, folder / "out.obj", false)->left_out,
              ElementsAre(".profile", "maps/.git/hook"));
}

TEST_F(PlacedArchive, AFileWithOtherContentStopsAll) {
  folder_.write("scan.mtl", "mine");
  const Status status = place_mesh(archive_, mesh_, folder_ / "out.obj", false).status();
  EXPECT_EQ(status.code(), StatusCode::kAlreadyExists);
  EXPECT_THAT(status.message(), HasSubstr((folder_ / "scan.mtl").string()));
  EXPECT_EQ(folder_.file_count(), 1u);
  EXPECT_TRUE(place_mesh(archive_, mesh_, folder_ / "out.obj", true).is_ok());
  EXPECT_EQ(content_of(folder_ / "scan.mtl"), "newmtl a\n");
}

TEST_F(PlacedArchive, AFileWithTheSameContentStays) {
  ASSERT_TRUE(place_mesh(archive_, mesh_, folder_ / "out.obj", false).is_ok());
  const auto time = std::filesystem::last_write_time(folder_ / "scan.mtl");
  EXPECT_TRUE(place_mesh(archive_, mesh_, folder_ / "again.obj", false).is_ok());
  EXPECT_EQ(std::filesystem::last_write_time(folder_ / "scan.mtl"), time);
}

TEST(PlaceFilesOf, AnObjsFilesFollowItIntoAnotherFolder) {
  const TexturedFolder from;
  const TemporaryFolder to;
  ASSERT_TRUE(place_files_of(from / "scan.obj", to / "out.obj", false).is_ok());
  EXPECT_EQ(content_of(to / "maps/skin.gif"), "skin");
  EXPECT_EQ(content_of(to / "shine.gif"), "shine");
  EXPECT_EQ(content_of(to / "scan.mtl"), content_of(from / "scan.mtl"));
  EXPECT_EQ(to.file_count(), 3u);
  EXPECT_TRUE(place_files_of(from / "scan.obj", from / "out.obj", false).is_ok());
  EXPECT_EQ(from.file_count(), 5u);
}

TEST(CheckPlacesOf, AFileThatWouldBeReplacedIsNamedBeforeItIs) {
  const TexturedFolder from;
  const TemporaryFolder to;
  EXPECT_TRUE(check_places_of(from / "scan.obj", to / "out.obj", {}).is_ok());
  to.write("scan.mtl", content_of(from / "scan.mtl"));
  EXPECT_TRUE(check_places_of(from / "scan.obj", to / "out.obj", {}).is_ok());
  to.write("shine.gif", "mine");
  const Status refused = check_places_of(from / "scan.obj", to / "out.obj", {});
  EXPECT_EQ(refused.code(), StatusCode::kAlreadyExists);
  EXPECT_THAT(refused.message(), HasSubstr((to / "shine.gif").string()));
  EXPECT_TRUE(check_places_of(from / "scan.obj", to / "out.ply", {}).is_ok());
}

TEST(CheckPlacesOf, DataThatWillChangeMustHaveAFreePlace) {
  const TemporaryFolder from, to;
  const std::string buffer = R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "scan.bin"}]})";
  const std::vector<std::string> buffers = {"scan.bin"};
  from.write("scan.bin", "data");
  const auto gltf = from.write("scan.gltf", buffer);
  EXPECT_TRUE(check_places_of(gltf, to / "out.gltf", buffers).is_ok());
  to.write("scan.bin", "data");
  for (const auto& out : {to / "out.gltf", from / "out.gltf"}) {
    const Status refused = check_places_of(gltf, out, buffers);
    EXPECT_EQ(refused.code(), StatusCode::kAlreadyExists);
    EXPECT_THAT(refused.message(), HasSubstr("scan.bin is there"));
  }
}

}  // namespace
}  // namespace burnish

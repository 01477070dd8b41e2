#include "client/model/files/file_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

std::vector<std::string> names_of(const std::vector<ListedFile>& files) {
  std::vector<std::string> names;
  for (const ListedFile& file : files) names.push_back(file.name);
  return names;
}

TEST(FileList, FoldersComeFirstAndOtherFormatsAndHiddenFilesAreLeftOut) {
  const TemporaryFolder folder;
  folder.write("b.PLY", "12345");
  folder.write("A.obj", "");
  folder.write("letter.txt", "");
  folder.write(".hidden.ply", "");
  std::filesystem::create_directory(folder / "z scans");
  const auto files = list_folder(folder / "", {".ply", ".obj"});
  ASSERT_TRUE(files.is_ok()) << files.status().message();
  EXPECT_EQ(names_of(*files), (std::vector<std::string>{"z scans", "A.obj", "b.PLY"}));
  EXPECT_TRUE(files->at(0).is_folder);
  EXPECT_EQ(files->at(2).size_bytes, 5u);
  EXPECT_GT(files->at(2).changed_unix_seconds, 1'600'000'000);
  EXPECT_EQ(list_folder(folder / "", {})->size(), 4u);
}

TEST(FileList, AFolderThatIsNotThereIsNamed) {
  const TemporaryFolder folder;
  const auto files = list_folder(folder / "nowhere", {});
  EXPECT_EQ(files.status().code(), StatusCode::kNotFound);
  EXPECT_THAT(files.status().message(), testing::HasSubstr("nowhere"));
}

TEST(FileList, TypedTextIsFoundInsideANameInAnyCase) {
  EXPECT_TRUE(has_text("Grab_17.PLY", "b_17.p"));
  EXPECT_TRUE(has_text("Grab_17.PLY", ""));
  EXPECT_FALSE(has_text("Grab_17.PLY", "18"));
}

TEST(FileList, PlacesAreTheHomeAndRecentFoldersThatAreThereOnce) {
  const TemporaryFolder folder;
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  setenv("HOME", (folder / "ada").c_str(), 1);
  std::filesystem::create_directories(folder / "ada/Downloads");
  std::filesystem::create_directories(folder / "scans");
  const auto places = places_to_look({folder / "scans", folder / "gone", folder / "ada/Downloads"});
  setenv("HOME", home.c_str(), 1);
  std::vector<std::string> names;
  for (const Place& place : places) names.push_back(place.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Home", "Downloads", "scans", "Computer"}));
}

}  // namespace
}  // namespace burnish

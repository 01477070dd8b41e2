#include "common/mesh/files/files_beside.h"

#include <gtest/gtest.h>

#include "common/mesh/files/folder_files.h"
#include "tests/common/mesh/textured_square.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

TEST(FilesBeside, NamesAreSoughtInTheFolderOfTheText) {
  FilesInMemory beside;
  beside.files = {{"a.png", ""}, {"maps/a.png", ""}, {"maps/b.png", ""}};
  EXPECT_EQ(beside.find("", "a.png"), "a.png");
  EXPECT_EQ(beside.find("maps", "a.png"), "maps/a.png");
  EXPECT_EQ(beside.find("", "maps\\b.png"), "maps/b.png");
  EXPECT_EQ(beside.find("maps", "../a.png"), "a.png");
  EXPECT_EQ(beside.find("", "./maps//b.png"), "maps/b.png");
  EXPECT_EQ(beside.find("", "b.png"), std::nullopt);
}

TEST(FilesBeside, PathsOfOtherMachinesCountByTheirLastPart) {
  FilesInMemory beside;
  beside.files = {{"skin.png", ""}};
  EXPECT_EQ(beside.find("", "C:\\Users\\me\\skin.png"), "skin.png");
  EXPECT_EQ(beside.find("", "/home/me/skin.png"), "skin.png");
  EXPECT_EQ(beside.find("", "../../skin.png"), "skin.png");
  EXPECT_EQ(beside.find("", ".."), std::nullopt);
  EXPECT_EQ(beside.find("", ""), std::nullopt);
}

TEST(FolderFiles, NamesMayDifferInCapitalLettersIfNoOtherDoes) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "Maps");
  folder.write("Maps/SKIN.png", "pixels");
  folder.write("a.mtl", "");
  folder.write("A.mtl", "");
  folder.write("b.MTL", "");
  folder.write("B.mtl", "");
  const FolderFiles files(folder.path());
  EXPECT_EQ(files.find("maps", "skin.PNG"), "Maps/SKIN.png");
  EXPECT_EQ(files.find("", "A.mtl"), "A.mtl");
  EXPECT_EQ(files.find("", "b.mtl"), std::nullopt);
  EXPECT_EQ(files.find("", "c.mtl"), std::nullopt);
}

TEST(FolderFiles, LinksThatLeadOutOfTheFolderAreNotFollowed) {
  const TemporaryFolder outside, folder;
  outside.write("secret.png", "secret");
  folder.write("skin.png", "pixels");
  std::filesystem::create_symlink(outside / "secret.png", folder / "link.png");
  std::filesystem::create_symlink(folder / "skin.png", folder / "inside.png");
  std::filesystem::create_directory(folder / "maps");
  const FolderFiles files(folder / "");
  EXPECT_EQ(files.find("", "link.png"), std::nullopt);
  EXPECT_EQ(files.find("", "maps"), std::nullopt);
  EXPECT_EQ(files.find("", "inside.png"), "inside.png");
  EXPECT_EQ(files.read("skin.png").value().size(), 6u);
}

}  // namespace
}  // namespace burnish

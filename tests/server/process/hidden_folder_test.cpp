#include "server/process/hidden_folder.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

std::string name_of(const std::string& id) {
  return id == "12ab" ? "igea" : id;
}

class HiddenFolderTest : public testing::Test {
 protected:
  HiddenFolder folder_{"/var/my data", name_of};
};

TEST_F(HiddenFolderTest, AFileOfAScanIsNamedByTheScan) {
  EXPECT_EQ(text_for_client("/var/my data/scans/12ab/level.pages: page 0: its checksum is wrong"),
            "level.pages of scan igea: page 0: its checksum is wrong");
  EXPECT_EQ(text_for_client("the original is damaged (/var/my data/scans/12ab/original.ply)"),
            "the original is damaged (original.ply of scan igea)");
  EXPECT_EQ(text_for_client("folder /var/my data/scans/12ab does not hold a scan"),
            "folder scan igea does not hold a scan");
}

TEST_F(HiddenFolderTest, OtherFilesLoseTheirFolder) {
  EXPECT_EQ(text_for_client("cannot write /var/my data/staging/77.ply: No space left"),
            "cannot write a temporary file: No space left");
  EXPECT_EQ(text_for_client("cannot rename /var/my data/staging/a to /var/my data/b.sqlite"),
            "cannot rename a temporary file to b.sqlite");
}

TEST_F(HiddenFolderTest, OtherTextsStayAsTheyAre) {
  for (const char* text : {"no scan '/var/my'", "", "s/var/my data/x is a name"})
    EXPECT_EQ(text_for_client(text), text);
}

TEST(HiddenFolder, WithoutOneNothingIsHidden) {
  EXPECT_EQ(text_for_client("/var/my data/scans/12ab/a"), "/var/my data/scans/12ab/a");
}

}  // namespace
}  // namespace burnish

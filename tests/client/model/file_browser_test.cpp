#include "client/model/files/file_browser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

class FileBrowserTest : public testing::Test {
 protected:
  FileBrowserTest() {
    std::filesystem::create_directory(folder_ / "tombs");
    folder_.write("head.ply", "1");
    folder_.write("hand.ply", "2");
    folder_.write("tombs/grab.obj", "3");
  }
  FileBrowser opening() const {
    return FileBrowser({.extensions = {".ply", ".obj"}, .start = folder_ / ""});
  }
  FileBrowser saving() const {
    return FileBrowser({.purpose = FileQuestion::Purpose::kSave,
                        .extensions = {".ply", ".obj"},
                        .start = folder_ / "head-edited.ply"});
  }

  const TemporaryFolder folder_;
};

TEST_F(FileBrowserTest, TypingFiltersAndEnterOpensTheFirstThatFits) {
  FileBrowser browser = opening();
  EXPECT_EQ(browser.shown().size(), 3u);
  browser.type("hea");
  ASSERT_EQ(browser.shown().size(), 1u);
  EXPECT_EQ(browser.enter(), folder_ / "head.ply");
}

TEST_F(FileBrowserTest, EnterGoesIntoAFolderAndUpComesBack) {
  FileBrowser browser = opening();
  browser.type("tomb");
  EXPECT_FALSE(browser.enter().has_value());
  EXPECT_EQ(browser.folder().filename(), "tombs");
  EXPECT_EQ(browser.typed(), "");
  EXPECT_EQ(browser.shown().at(0).name, "grab.obj");
  browser.up();
  EXPECT_EQ(browser.shown().size(), 3u);
}

TEST_F(FileBrowserTest, TheArrowsChooseAndStopAtTheEnds) {
  FileBrowser browser = opening();
  for (const char* name : {"tombs", "hand.ply", "head.ply", "head.ply"}) {
    browser.move(1);
    EXPECT_EQ(browser.chosen(), name);
  }
  browser.move(-1);
  EXPECT_EQ(browser.enter(), folder_ / "hand.ply");
}

TEST_F(FileBrowserTest, ATypedPathIsTakenWithTheHomeFolderForATilde) {
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  setenv("HOME", (folder_ / "").c_str(), 1);
  FileBrowser browser = opening();
  browser.type("~/tombs");
  EXPECT_FALSE(browser.enter().has_value());
  EXPECT_EQ(browser.folder().filename(), "tombs");
  browser.type("~/head.ply");
  const auto file = browser.enter();
  setenv("HOME", home.c_str(), 1);
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->filename(), "head.ply");
}

TEST_F(FileBrowserTest, TextThatFitsNothingAndAPathThatIsNotThereAreNamed) {
  FileBrowser browser = opening();
  browser.type("foot");
  EXPECT_FALSE(browser.enter().has_value());
  EXPECT_THAT(browser.problem(), testing::HasSubstr("foot"));
  browser.type((folder_ / "nowhere.ply").string());
  EXPECT_EQ(browser.problem(), "");
  EXPECT_FALSE(browser.enter().has_value());
  EXPECT_THAT(browser.problem(), testing::HasSubstr("nowhere.ply"));
}

TEST_F(FileBrowserTest, SavingBeginsWithTheSuggestedNameAndAddsAnExtension) {
  FileBrowser browser = saving();
  EXPECT_EQ(browser.typed(), "head-edited.ply");
  EXPECT_EQ(browser.shown().size(), 3u);
  browser.type("smooth");
  EXPECT_EQ(browser.enter(), folder_ / "smooth.ply");
}

TEST_F(FileBrowserTest, SavingAsksBeforeItReplacesAFile) {
  FileBrowser browser = saving();
  browser.choose(browser.shown().at(1));
  EXPECT_EQ(browser.typed(), "hand.ply");
  EXPECT_FALSE(browser.enter().has_value());
  EXPECT_TRUE(browser.replaces());
  browser.type("hand.pl");
  browser.type("hand.ply");
  EXPECT_FALSE(browser.enter().has_value());
  EXPECT_EQ(browser.enter(), folder_ / "hand.ply");
}

}  // namespace
}  // namespace burnish

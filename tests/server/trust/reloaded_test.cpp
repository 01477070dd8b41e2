#include "server/trust/reloaded.h"

#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

class ReloadedTest : public testing::Test {
 protected:
  ReloadedTest() { write("one"); }

  void write(const std::string& text) { folder_.write("file", text); }

  Result<std::string> read() {
    ++reads_;
    const std::string text = content_of(folder_ / "file");
    if (text == "bad") return invalid_argument("bad");
    return text;
  }

  TemporaryFolder folder_;
  int reads_ = 0;
  std::unique_ptr<Reloaded<std::string>> open() {
    return std::move(
               Reloaded<std::string>::open({folder_ / "file"}, [this] { return this->read(); }))
        .value();
  }
};

TEST_F(ReloadedTest, ReadsAgainOnlyWhatHasChanged) {
  const auto file = open();
  EXPECT_EQ(*file->get(), "one");
  EXPECT_FALSE(file->refresh(false).value());
  EXPECT_EQ(reads_, 1);
  write("second");
  EXPECT_TRUE(file->refresh(false).value());
  EXPECT_EQ(*file->get(), "second");
}

TEST_F(ReloadedTest, ReadsAgainWhenToldToInAnyCase) {
  const auto file = open();
  EXPECT_TRUE(file->refresh(true).value());
  EXPECT_EQ(reads_, 2);
}

TEST_F(ReloadedTest, AChangeThatCannotBeReadLeavesWhatThereWas) {
  const auto file = open();
  write("bad");
  EXPECT_FALSE(file->refresh(false).is_ok());
  EXPECT_EQ(*file->get(), "one");
  EXPECT_FALSE(file->refresh(false).value());  // reported once
  write("three");
  EXPECT_TRUE(file->refresh(false).value());
  EXPECT_EQ(*file->get(), "three");
}

TEST_F(ReloadedTest, FailsToOpenWhatCannotBeRead) {
  write("bad");
  EXPECT_FALSE(Reloaded<std::string>::open({folder_ / "file"}, [this] { return read(); }).is_ok());
}

}  // namespace
}  // namespace burnish

#include "common/base/scratch_file.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

TEST(ScratchFile, PartsComeBackWhereTheyWereWritten) {
  const TemporaryFolder folder;
  const ScratchFile file = ScratchFile::create(folder.path()).value();
  const std::vector<uint8_t> written = {1, 2, 3};
  ASSERT_TRUE(file.write(1000, written).is_ok());
  std::vector<uint8_t> read(3);
  ASSERT_TRUE(file.read(1000, read).is_ok());
  EXPECT_EQ(read, written);
  ASSERT_TRUE(file.read(500, read).is_ok());
  EXPECT_EQ(read, std::vector<uint8_t>(3, 0));
}

TEST(ScratchFile, HasNoName) {
  const TemporaryFolder folder;
  const ScratchFile file = ScratchFile::create(folder.path()).value();
  ASSERT_TRUE(file.write(0, std::vector<uint8_t>{1}).is_ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ScratchFile, ReservedRoomIsZero) {
  const TemporaryFolder folder;
  ScratchFile file = ScratchFile::create(folder.path()).value();
  ASSERT_TRUE(file.reserve(10).is_ok());
  std::vector<uint8_t> read(10, 7);
  ASSERT_TRUE(file.read(0, read).is_ok());
  EXPECT_EQ(read, std::vector<uint8_t>(10, 0));
}

TEST(ScratchFile, ReadingBeyondTheEndFails) {
  const TemporaryFolder folder;
  const ScratchFile file = ScratchFile::create(folder.path()).value();
  std::vector<uint8_t> read(1);
  EXPECT_EQ(file.read(0, read).code(), StatusCode::kDataLoss);
}

TEST(ScratchFile, AFolderThatIsNotThereIsNamed) {
  const Status status = ScratchFile::create("/there/is/none").status();
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_NE(status.message().find("/there/is/none"), std::string::npos);
}

}  // namespace
}  // namespace burnish

#include "common/base/file_reader.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class FileReaderTest : public testing::Test {
 protected:
  FileReaderTest() { std::ofstream(path_) << "0123456789"; }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "digits";
};

TEST_F(FileReaderTest, ReadsAnyPart) {
  const FileReader file = FileReader::open(path_).value();
  EXPECT_EQ(file.file_bytes(), 10u);
  EXPECT_EQ(file.read(3, 4).value(), (std::vector<uint8_t>{'3', '4', '5', '6'}));
  EXPECT_TRUE(file.read(10, 0).value().empty());
}

TEST_F(FileReaderTest, APartBeyondTheEndIsDataLoss) {
  const FileReader file = FileReader::open(path_).value();
  const Status status = file.read(8, 3).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_THAT(status.message(), HasSubstr("ended after 10 of 11 bytes"));
}

TEST_F(FileReaderTest, AFileThatIsCutWhileItIsOpenIsDataLoss) {
  const FileReader file = FileReader::open(path_).value();
  std::filesystem::resize_file(path_, 4);
  EXPECT_EQ(file.read(2, 5).status().code(), StatusCode::kDataLoss);
  EXPECT_TRUE(file.read(0, 4).is_ok());
}

TEST_F(FileReaderTest, AMovedReaderReads) {
  FileReader first = FileReader::open(path_).value();
  const FileReader second = std::move(first);
  EXPECT_EQ(second.read(0, 1).value(), std::vector<uint8_t>{'0'});
}

TEST_F(FileReaderTest, AFolderIsNotAFile) {
  EXPECT_EQ(FileReader::open(folder_ / "").status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(FileReader::open(folder_ / "absent").status().code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish

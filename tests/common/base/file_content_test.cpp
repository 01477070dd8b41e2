#include "common/base/file_content.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

std::string text_of(const FileContent& content) {
  return {content.bytes().begin(), content.bytes().end()};
}

TEST(FileContent, IsTheFilesBytesAtAMultipleOf64) {
  const TemporaryFolder folder;
  const auto content = FileContent::read(folder.write("a", std::string("one\0two", 7))).value();
  EXPECT_EQ(text_of(content), std::string("one\0two", 7));
  EXPECT_EQ(reinterpret_cast<uintptr_t>(content.bytes().data()) % 64, 0u);
}

TEST(FileContent, OfItsBeginningKnowsTheWholeLength) {
  const TemporaryFolder folder;
  const auto content = FileContent::read_beginning(folder.write("a", "one two"), 3).value();
  EXPECT_EQ(text_of(content), "one");
  EXPECT_EQ(content.file_bytes(), 7u);
}

TEST(FileContent, StaysWhenTheFileIsCut) {
  const TemporaryFolder folder;
  const auto path = folder.write("a", std::string(100'000, 'x'));
  const auto content = FileContent::read(path).value();
  std::filesystem::resize_file(path, 0);
  EXPECT_EQ(text_of(content), std::string(100'000, 'x'));
}

TEST(FileContent, OfWhatIsNotAFileIsRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(FileContent::read(folder / "nothing").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(FileContent::read(folder / ".").status().code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(FileContent::read(folder.write("empty", "")).value().bytes().empty());
}

}  // namespace
}  // namespace burnish

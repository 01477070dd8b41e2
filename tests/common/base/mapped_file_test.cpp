#include "common/base/mapped_file.h"

#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/common/temporary_folder.h"

namespace burnish {

using testing::HasSubstr;

static constexpr uid_t kNobody = 65534;

static std::string text_of(const MappedFile& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

TEST(MappedFile, HoldsTheFilesBytes) {
  TemporaryFolder folder;
  const auto file = MappedFile::open(folder.write("a", std::string("one\0two", 7)));
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  EXPECT_EQ(text_of(*file), std::string("one\0two", 7));
}

TEST(MappedFile, AnEmptyFileHasNoBytes) {
  TemporaryFolder folder;
  const auto file = MappedFile::open(folder.write("a", ""));
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  EXPECT_TRUE(file->bytes().empty());
}

TEST(MappedFile, KeepsItsBytesWhenMovedAndWhenTheFileIsReplaced) {
  TemporaryFolder folder;
  auto opened = MappedFile::open(folder.write("a", "old"));
  ASSERT_TRUE(opened.is_ok());
  const MappedFile file = std::move(opened).value();
  std::filesystem::rename(folder.write("b", "new"), folder / "a");
  EXPECT_EQ(text_of(file), "old");
}

TEST(MappedFile, AMissingFileIsNotFoundByName) {
  TemporaryFolder folder;
  const auto file = MappedFile::open(folder / "absent.ply");
  ASSERT_FALSE(file.is_ok());
  EXPECT_EQ(file.status().code(), StatusCode::kNotFound);
  EXPECT_THAT(file.status().message(), HasSubstr("absent.ply: No such file"));
}

TEST(MappedFile, RefusesADirectory) {
  TemporaryFolder folder;
  const auto file = MappedFile::open(folder / "");
  ASSERT_FALSE(file.is_ok());
  EXPECT_EQ(file.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(file.status().message(), HasSubstr("is a directory"));
}

TEST(MappedFile, RefusesAPipeWithoutWaitingForItsWriter) {
  TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  const auto file = MappedFile::open(folder / "pipe");
  ASSERT_FALSE(file.is_ok());
  EXPECT_THAT(file.status().message(), HasSubstr("not a regular file"));
}

TEST(MappedFile, AnUnreadableFileIsPermissionDenied) {
  TemporaryFolder folder;
  const auto path = folder.write("a", "secret");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  const bool is_root = geteuid() == 0;  // root can read everything
  if (is_root) {
    ASSERT_EQ(seteuid(kNobody), 0);
  }
  const auto file = MappedFile::open(path);
  if (is_root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  ASSERT_FALSE(file.is_ok());
  EXPECT_EQ(file.status().code(), StatusCode::kPermissionDenied);
}

}  // namespace burnish

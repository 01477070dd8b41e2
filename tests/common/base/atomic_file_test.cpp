#include "common/base/atomic_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/base/file_size_limit.h"
#include "tests/common/temporary_folder.h"

namespace burnish {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(AtomicFile, AppearsWithItsContentOnCommit) {
  TemporaryFolder folder;
  auto file = AtomicFile::create(folder / "a");
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  ASSERT_TRUE(file->write("one ").is_ok());
  ASSERT_TRUE(file->write("two").is_ok());
  EXPECT_FALSE(fs::exists(folder / "a"));
  ASSERT_TRUE(file->commit().is_ok());
  EXPECT_EQ(content_of(folder / "a"), "one two");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, WithoutCommitTheOldFileStaysAndNothingIsLeftBeside) {
  TemporaryFolder folder;
  folder.write("a", "old");
  {
    auto file = AtomicFile::create(folder / "a");
    ASSERT_TRUE(file.is_ok());
    ASSERT_TRUE(file->write("new").is_ok());
    const AtomicFile moved = std::move(file).value();
  }
  EXPECT_EQ(content_of(folder / "a"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, ReplacesAFileAndKeepsItsPermissions) {
  TemporaryFolder folder;
  fs::permissions(folder.write("a", "old"), fs::perms::owner_read | fs::perms::owner_write);
  auto file = AtomicFile::create(folder / "a");
  ASSERT_TRUE(file.is_ok());
  ASSERT_TRUE(file->write("new").is_ok());
  ASSERT_TRUE(file->commit().is_ok());
  EXPECT_EQ(content_of(folder / "a"), "new");
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(AtomicFile, ForItsUserAloneIsClosedAlsoWhereTheOldOneWasNot) {
  TemporaryFolder folder;
  fs::permissions(folder.write("a", "old"), fs::perms(0644));
  ASSERT_TRUE(write_file(folder / "a", "new", FileAccess::kUserOnly).is_ok());
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0600));
}

TEST(AtomicFile, FollowsALink) {
  TemporaryFolder folder;
  folder.write("target", "old");
  fs::create_symlink("target", folder / "link");
  auto file = AtomicFile::create(folder / "link");
  ASSERT_TRUE(file.is_ok());
  ASSERT_TRUE(file->write("new").is_ok());
  ASSERT_TRUE(file->commit().is_ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content_of(folder / "target"), "new");
}

TEST(AtomicFile, TwoWritersOfOnePathDoNotMix) {
  TemporaryFolder folder;
  auto first = AtomicFile::create(folder / "a");
  auto second = AtomicFile::create(folder / "a");
  ASSERT_TRUE(first.is_ok() && second.is_ok());
  ASSERT_TRUE(first->write("first").is_ok());
  ASSERT_TRUE(second->write("second").is_ok());
  ASSERT_TRUE(second->commit().is_ok());
  ASSERT_TRUE(first->commit().is_ok());
  EXPECT_EQ(content_of(folder / "a"), "first");
}

TEST(AtomicFile, AMissingFolderIsNotFound) {
  TemporaryFolder folder;
  const auto file = AtomicFile::create(folder / "absent/a");
  ASSERT_FALSE(file.is_ok());
  EXPECT_EQ(file.status().code(), StatusCode::kNotFound);
  EXPECT_THAT(file.status().message(), HasSubstr("absent/a"));
}

TEST(AtomicFile, RefusesDirectoriesAndDevices) {
  TemporaryFolder folder;
  fs::create_directory(folder / "directory");
  const auto directory = AtomicFile::create(folder / "directory");
  ASSERT_FALSE(directory.is_ok());
  EXPECT_THAT(directory.status().message(), HasSubstr("is a directory"));
  const auto device = AtomicFile::create("/dev/full");
  ASSERT_FALSE(device.is_ok());
  EXPECT_THAT(device.status().message(), HasSubstr("/dev/full: it is not a regular file"));
}

TEST(AtomicFile, AFullDiskIsResourceExhaustedAndLeavesTheOldFile) {
  TemporaryFolder folder;
  folder.write("a", "old");
  {
    const FileSizeLimit limit(100);
    auto file = AtomicFile::create(folder / "a");
    ASSERT_TRUE(file.is_ok());
    const Status status = file->write(std::string(1000, 'x'));
    EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
    EXPECT_THAT(status.message(), HasSubstr("cannot write " + (folder / "a").string()));
  }
  EXPECT_EQ(content_of(folder / "a"), "old");
}

TEST(AtomicFile, ATargetThatBecameADirectoryFailsTheCommitAndLeavesNothing) {
  TemporaryFolder folder;
  {
    auto file = AtomicFile::create(folder / "a");
    ASSERT_TRUE(file.is_ok());
    fs::create_directory(folder / "a");
    const Status status = file->commit();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(status.message(), HasSubstr("cannot rename"));
  }
  EXPECT_EQ(folder.file_count(), 1u);
}

}  // namespace burnish

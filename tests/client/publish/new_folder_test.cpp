#include "client/publish/new_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/atomic_file.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string no_objection(const fs::path&) {
  return {};
}
std::string objection(const fs::path& folder) {
  return folder.filename().string() + " is taken";
}

Status write_into(const fs::path& target, const NewFolder::Guard& guard, bool commits = true) {
  ASSIGN_OR_RETURN(NewFolder folder, NewFolder::create(target, guard));
  RETURN_IF_ERROR(write_file(folder.path() / "new.txt", "new"));
  return commits ? folder.commit() : Status::ok();
}

TEST(NewFolder, IsInItsPlaceAfterTheCommitAlone) {
  const TemporaryFolder around;
  ASSERT_TRUE(write_into(around / "out", objection, false).is_ok());
  EXPECT_EQ(around.file_count(), 0U);
  ASSERT_TRUE(write_into(around / "out/", objection).is_ok());
  EXPECT_EQ(content_of(around / "out/new.txt"), "new");
  EXPECT_EQ(around.file_count(), 1U);
}

TEST(NewFolder, TakesThePlaceOfAnEmptyOne) {
  const TemporaryFolder around;
  fs::create_directory(around / "out");
  ASSERT_TRUE(write_into(around / "out", objection).is_ok());
  EXPECT_TRUE(fs::exists(around / "out/new.txt"));
}

TEST(NewFolder, LeavesAnotherOneThatMayNotBeReplaced) {
  const TemporaryFolder around;
  fs::create_directory(around / "out");
  ASSERT_TRUE(write_file(around / "out/old.txt", "old").is_ok());
  const Status refused = write_into(around / "out", objection);
  EXPECT_EQ(refused.code(), StatusCode::kAlreadyExists);
  EXPECT_THAT(refused.message(), HasSubstr("out is taken"));
  EXPECT_TRUE(fs::exists(around / "out/old.txt"));
  EXPECT_EQ(around.file_count(), 1U);
}

TEST(NewFolder, ReplacesAllOfOneThatMayBeReplaced) {
  const TemporaryFolder around;
  fs::create_directory(around / "out");
  ASSERT_TRUE(write_file(around / "out/old.txt", "old").is_ok());
  ASSERT_TRUE(write_into(around / "out", no_objection).is_ok());
  EXPECT_FALSE(fs::exists(around / "out/old.txt"));
  EXPECT_TRUE(fs::exists(around / "out/new.txt"));
  EXPECT_EQ(around.file_count(), 1U);
}

TEST(NewFolder, IsRefusedWhereAFileIsOrNoFolderIsAround) {
  const TemporaryFolder around;
  around.write("file", "text");
  EXPECT_THAT(write_into(around / "file", no_objection).message(), HasSubstr("is no folder"));
  EXPECT_EQ(write_into(around / "none/out", no_objection).code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish

#include "server/library/data_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

TEST(DataFolder, ASecondOwnerIsRefusedByName) {
  const TemporaryFolder root;
  const auto first = DataFolder::open(root / "data");
  ASSERT_TRUE(first.is_ok());
  const auto second = DataFolder::open(root / "data");
  EXPECT_EQ(second.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(second.status().message(), testing::HasSubstr((root / "data").string()));
}

TEST(DataFolder, IsForItsOwnerAloneWhateverTheUmask) {
  const TemporaryFolder root;
  const mode_t umask_before = ::umask(0);
  const auto folder = DataFolder::open(root / "data");
  ::umask(umask_before);
  ASSERT_TRUE(folder.is_ok());
  for (const char* name : {"data", "data/scans", "data/staging"})
    EXPECT_EQ(std::filesystem::status(root / name).permissions(), std::filesystem::perms::owner_all)
        << name;
}

TEST(DataFolder, TheLockGoesWithItsOwner) {
  const TemporaryFolder root;
  { ASSERT_TRUE(DataFolder::open(root / "data").is_ok()); }
  EXPECT_TRUE(DataFolder::open(root / "data").is_ok());
}

TEST(DataFolder, GivesItsSpareRoomBackInPartsAndTakesItAgain) {
  const TemporaryFolder root;
  auto opened = DataFolder::open(root / "data");
  const auto& folder = opened.value();
  EXPECT_FALSE(folder->give_spare());
  folder->keep_spare();
  const uint64_t kept = std::filesystem::file_size(root / "data/spare");
  int starts = 0;
  while (folder->give_spare()) ++starts;
  EXPECT_EQ(starts, 8);
  EXPECT_EQ(std::filesystem::file_size(root / "data/spare"), 0u);
  folder->keep_spare();
  EXPECT_EQ(std::filesystem::file_size(root / "data/spare"), kept);
}

TEST(DataFolder, OpeningEmptiesStaging) {
  const TemporaryFolder root;
  std::filesystem::create_directories(root / "data/staging");
  root.write("data/staging/half.upload", "half");
  const auto folder = DataFolder::open(root / "data");
  EXPECT_FALSE(std::filesystem::exists(root / "data/staging/half.upload"));
  EXPECT_TRUE(std::filesystem::exists(root / "data/staging"));
}

TEST(DataFolder, NobodyElseCanOpenItsLock) {
  const TemporaryFolder root;
  std::filesystem::create_directories(root / "data");
  root.write("data/lock", "");
  std::filesystem::permissions(root / "data/lock", std::filesystem::perms(0644));  // an old one
  const auto folder = DataFolder::open(root / "data");
  ASSERT_TRUE(folder.is_ok());
  EXPECT_EQ(std::filesystem::status(root / "data/lock").permissions(),
            std::filesystem::perms(0600));
}

TEST(DataFolder, AFileInItsPlaceIsRefused) {
  const TemporaryFolder root;
  root.write("data", "a file");
  EXPECT_FALSE(DataFolder::open(root / "data").is_ok());
}

}  // namespace
}  // namespace burnish

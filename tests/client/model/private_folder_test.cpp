#include "client/model/files/private_folder.h"

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::perms mode_of(const fs::path& path) {
  return fs::status(path).permissions();
}

TEST(PrivateFolder, IsMadeForItsUserAloneAndStays) {
  const TemporaryFolder folder;
  const auto path = folder / "above/data";
  ASSERT_TRUE(make_private_folder(path).is_ok());
  EXPECT_EQ(mode_of(path), fs::perms(0700));
  EXPECT_TRUE(make_private_folder(path).is_ok());
}

TEST(PrivateFolder, OneThatOthersCouldReadIsClosed) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "data");
  fs::permissions(folder / "data", fs::perms(0755));
  ASSERT_TRUE(make_private_folder(folder / "data").is_ok());
  EXPECT_EQ(mode_of(folder / "data"), fs::perms(0700));
}

TEST(PrivateFolder, OneThatOthersCouldWriteIsRefusedWithItsMode) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "data");
  fs::permissions(folder / "data", fs::perms(0775));
  const Status status = make_private_folder(folder / "data");
  EXPECT_EQ(status.code(), StatusCode::kPermissionDenied);
  EXPECT_THAT(status.message(), HasSubstr((folder / "data").string() + " has mode 0775"));
  EXPECT_EQ(mode_of(folder / "data"), fs::perms(0775));
}

TEST(PrivateFolder, ALinkAndAFileAreRefused) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "real");
  fs::create_directory_symlink(folder / "real", folder / "link");
  for (const char* name : {"link", "link/"}) {
    const Status status = make_private_folder(folder / name);
    EXPECT_EQ(status.code(), StatusCode::kPermissionDenied) << name;
    EXPECT_THAT(status.message(), HasSubstr("is a link"));
  }
  EXPECT_THAT(make_private_folder(folder.write("file", "")).message(), HasSubstr("is a file"));
}

TEST(PrivateFolder, OneOfAnotherUserIsRefused) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  const TemporaryFolder folder;
  fs::create_directory(folder / "data");
  ASSERT_EQ(chown((folder / "data").c_str(), 65534, 65534), 0);
  EXPECT_THAT(make_private_folder(folder / "data").message(), HasSubstr("belongs to user 65534"));
}

}  // namespace
}  // namespace burnish

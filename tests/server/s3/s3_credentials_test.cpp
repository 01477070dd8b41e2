#include "server/s3/s3_credentials.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class S3CredentialsFile : public testing::Test {
 protected:
  Result<S3Credentials> read(const std::string& text, fs::perms mode = fs::perms::owner_read) {
    const fs::path file = folder_.write("credentials", text);
    fs::permissions(file, mode | fs::perms::owner_write);
    return read_s3_credentials(file);
  }

  const TemporaryFolder folder_;
};

TEST_F(S3CredentialsFile, HasTheFormOfAwsTools) {
  const auto found = read(
      "# ours\n[other]\naws_access_key_id = no\n[default]\r\naws_access_key_id=me\n"
      " aws_secret_access_key = a=b/c+d \naws_session_token = t\n[last]\naws_session_token = no\n");
  ASSERT_TRUE(found.is_ok()) << found.status().message();
  EXPECT_EQ(found->id, "me");
  EXPECT_EQ(found->secret, "a=b/c+d");
  EXPECT_EQ(found->token, "t");
}

TEST_F(S3CredentialsFile, NeedsNoSectionAndNoToken) {
  const auto found = read("aws_access_key_id = me\naws_secret_access_key = s\n");
  ASSERT_TRUE(found.is_ok()) << found.status().message();
  EXPECT_EQ(found->token, "");
}

TEST_F(S3CredentialsFile, NamesTheMissingLineAndNoValue) {
  const Status status = read("aws_secret_access_key = hidden\n").status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("aws_access_key_id"));
  EXPECT_THAT(status.message(), testing::Not(HasSubstr("hidden")));
  EXPECT_EQ(read_s3_credentials(folder_ / "none").status().code(), StatusCode::kNotFound);
}

TEST_F(S3CredentialsFile, ThatEverybodyCanReadIsRefused) {
  const Status status = read("x\n", fs::perms::others_read | fs::perms::owner_read).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("0604"));
}

TEST(S3CredentialsOfEnvironment, AreBothOrMissing) {
  ::setenv("AWS_ACCESS_KEY_ID", "me", 1);
  ::setenv("AWS_SECRET_ACCESS_KEY", "secret", 1);
  ::setenv("AWS_SESSION_TOKEN", "t", 1);
  const auto found = s3_credentials_of_environment();
  ASSERT_TRUE(found.is_ok());
  EXPECT_EQ(found->id + found->secret + found->token, "mesecrett");
  ::unsetenv("AWS_SECRET_ACCESS_KEY");
  const Status status = s3_credentials_of_environment().status();
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_THAT(status.message(), HasSubstr("AWS_SECRET_ACCESS_KEY"));
  ::unsetenv("AWS_ACCESS_KEY_ID");
  ::unsetenv("AWS_SESSION_TOKEN");
}

}  // namespace
}  // namespace burnish

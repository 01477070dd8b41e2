#include "server/trust/users.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

// SHA-256 of the token "abc" from FIPS 180-2.
constexpr char kAbcHash[] = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

Result<UserTable> read(const std::string& text) {
  const TemporaryFolder folder;
  return read_users_file(folder.write("users.toml", text));
}

std::string refusal(const std::string& text) {
  const auto table = read(text);
  return table.is_ok() ? "accepted" : table.status().message();
}

std::string user(const std::string& name, const std::string& proof) {
  return "[[user]]\nname = \"" + name + "\"\nrole = \"editor\"\n" + proof + "\n";
}

const std::string kToken = std::string("token_sha256 = \"") + kAbcHash + "\"";

TEST(Users, AreFoundByTokenAndByCertificate) {
  const auto table = read(user("anna", kToken) + user("bert", "certificate = \"bert.lab\""));
  ASSERT_TRUE(table.is_ok()) << table.status().message();
  ASSERT_NE(table.value().find_token("abc"), nullptr);
  EXPECT_EQ(table.value().find_token("abc")->name, "anna");
  EXPECT_EQ(table.value().find_token("abc")->role, Role::kEditor);
  EXPECT_EQ(table.value().find_token("abd"), nullptr);
  EXPECT_EQ(table.value().find_token(""), nullptr);
  EXPECT_EQ(table.value().find_token(kAbcHash), nullptr);
  ASSERT_NE(table.value().find_certificate("bert.lab"), nullptr);
  EXPECT_EQ(table.value().find_certificate("bert"), nullptr);
  EXPECT_EQ(table.value().find_certificate(""), nullptr);
}

TEST(Users, AWrongFileIsRefusedByLineKeyAndValue) {
  EXPECT_THAT(refusal("[[user]]\nname = 7\n"), EndsWith("users.toml:2: name: is not a string"));
  EXPECT_THAT(refusal("[[user]]\nname = \"a\"\nrole = \"king\"\n"),
              HasSubstr("users.toml:3: role: 'king' is not one of viewer, editor, owner"));
  EXPECT_THAT(refusal(user("a", "token_sha256 = \"12\"")), HasSubstr("64 lower-case hexadecimal"));
  EXPECT_THAT(refusal(user("a", "tokn = \"12\"")), HasSubstr("tokn: unknown key"));
  EXPECT_THAT(refusal(user("a", "")), HasSubstr("neither token_sha256 nor certificate"));
  EXPECT_THAT(refusal("[[user]]\nname = \"a\"\n" + kToken), HasSubstr("user a has no role"));
  EXPECT_THAT(refusal("users = 3\n"), HasSubstr("'users' is not a [[user]]"));
  EXPECT_THAT(refusal("[[user]\n"), HasSubstr("users.toml:1"));
}

TEST(Users, TwoOfOneNameOrTokenAreRefused) {
  EXPECT_THAT(refusal(user("a", kToken) + user("b", kToken)), HasSubstr("user b has the name"));
  EXPECT_THAT(refusal(user("a", kToken) + user("a", "certificate = \"x\"")), HasSubstr("user a"));
}

TEST(Users, TheExampleIsAccepted) {
  const auto table = read_users_file(SOURCE_ROOT "/deploy/users.example.toml");
  ASSERT_TRUE(table.is_ok()) << table.status().message();
  EXPECT_EQ(table.value().users().size(), 2u);
}

TEST(Users, AFileThatEverybodyWritesIsRefusedWithItsMode) {
  const TemporaryFolder folder;
  const auto path = folder.write("users.toml", user("anna", kToken));
  EXPECT_TRUE(read_users_file(path).is_ok());
  std::filesystem::permissions(path, std::filesystem::perms(0666));
  const Status status = read_users_file(path).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(),
              HasSubstr("users.toml can be written by everybody: its mode is 0666"));
}

}  // namespace
}  // namespace burnish

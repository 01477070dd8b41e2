#include "server/trust/guard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char kList[] = "/burnish.v1.Library/ListScans";
constexpr char kApply[] = "/burnish.v1.Editing/Apply";
constexpr char kDelete[] = "/burnish.v1.Library/DeleteScan";
constexpr char kHealth[] = "/grpc.health.v1.Health/Check";

class GuardTest : public testing::Test {
 protected:
  Status check(const char* method, const Proof& proof) const {
    return guard_.check(method, proof).status();
  }

  std::unique_ptr<Reloaded<UserTable>> users_ =
      std::move(Reloaded<UserTable>::open({}, []() -> Result<UserTable> {
        return UserTable({{"vera", Role::kViewer, hash_token("see"), ""},
                          {"otto", Role::kOwner, hash_token("own"), "otto"}});
      })).value();
  Guard guard_{users_.get()};
};

TEST_F(GuardTest, ATokenGivesItsUsersRole) {
  EXPECT_TRUE(check(kList, {"Bearer see", ""}).is_ok());
  EXPECT_TRUE(check(kDelete, {"Bearer own", ""}).is_ok());
  EXPECT_EQ(guard_.check(kDelete, {"Bearer own", ""}).value().user, "otto");
  const Status status = check(kApply, {"Bearer see", ""});
  EXPECT_EQ(status.code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(status.message(),
            "user vera is viewer; /burnish.v1.Editing/Apply needs the role editor");
}

TEST_F(GuardTest, TheSchemesNameMayHaveAnyCase) {
  for (const char* header : {"bearer see", "BEARER see", "bEaReR see"})
    EXPECT_TRUE(check(kList, {header, ""}).is_ok()) << header;
  EXPECT_EQ(check(kList, {"bearer", ""}).code(), StatusCode::kUnauthenticated);
}

TEST_F(GuardTest, ACertificateGivesItsUsersRole) {
  EXPECT_TRUE(check(kDelete, {"", "otto"}).is_ok());
  EXPECT_EQ(check(kList, {"", "nobody"}).code(), StatusCode::kUnauthenticated);
}

TEST_F(GuardTest, AWrongTokenIsNotSavedByACertificate) {
  EXPECT_EQ(check(kList, {"Bearer wrong", "otto"}).code(), StatusCode::kUnauthenticated);
}

TEST_F(GuardTest, MessagesNeverRepeatAToken) {
  for (const char* header : {"Bearer secret-word", "Basic secret-word", "secret-word"}) {
    const Status status = check(kList, {header, ""});
    EXPECT_EQ(status.code(), StatusCode::kUnauthenticated);
    EXPECT_THAT(status.message(), Not(HasSubstr("secret-word")));
  }
}

TEST_F(GuardTest, AnUnknownRpcIsRefusedToEverybody) {
  EXPECT_EQ(check("/burnish.v1.Library/Format", {"Bearer own", ""}).code(),
            StatusCode::kUnimplemented);
  EXPECT_EQ(check("", {"Bearer own", ""}).code(), StatusCode::kUnimplemented);
}

TEST_F(GuardTest, WhenClosedOnlyHealthIsLetIn) {
  guard_.close();
  EXPECT_EQ(check(kList, {"Bearer own", ""}).code(), StatusCode::kUnavailable);
  EXPECT_TRUE(check(kHealth, {}).is_ok());
}

TEST(Guard, WithoutUsersEverybodyIsOwner) {
  const Guard guard(nullptr);
  EXPECT_EQ(guard.check(kDelete, {}).value().role, Role::kOwner);
  EXPECT_EQ(guard.check(kDelete, {}).value().user, "");
}

}  // namespace
}  // namespace burnish

#include "common/service/session_roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(SessionRoles, OfANewSessionItsMakerIsTheOwnerAndOthersEdit) {
  const SessionRoles roles = SessionRoles::of_new_session("ann");
  EXPECT_EQ(roles.of("ann"), SessionRole::kOwner);
  EXPECT_EQ(roles.of("bob"), SessionRole::kEditor);
  EXPECT_EQ(roles.of(""), SessionRole::kEditor);
}

TEST(SessionRoles, ASessionOfNobodyInParticularIsEverybodys) {
  EXPECT_EQ(SessionRoles::of_new_session("").of("anybody"), SessionRole::kOwner);
}

TEST(SessionRoles, ARefusalNamesUserRoleAndNeed) {
  const SessionRoles roles({{"", SessionRole::kViewer}, {"ann", SessionRole::kOwner}});
  EXPECT_TRUE(roles.require("ann", SessionRole::kEditor, "editing").is_ok());
  const Status refused = roles.require("bob", SessionRole::kEditor, "editing");
  EXPECT_EQ(refused.code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(refused.message(), "editing needs the role editor; 'bob' is viewer of this session");
}

TEST(SessionRoles, AnOwnerIsAlwaysLeft) {
  SessionRoles roles = SessionRoles::of_new_session("ann");
  EXPECT_EQ(roles.set("ann", SessionRole::kViewer).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(roles.of("ann"), SessionRole::kOwner);
  EXPECT_TRUE(roles.set("bob", SessionRole::kOwner).is_ok());
  EXPECT_TRUE(roles.set("ann", SessionRole::kViewer).is_ok());
}

}  // namespace
}  // namespace burnish

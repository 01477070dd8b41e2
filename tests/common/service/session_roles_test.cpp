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

TEST(SessionRoles, AnOwnerIsAlwaysLeft) {
  SessionRoles roles = SessionRoles::of_new_session("ann");
  EXPECT_EQ(roles.set("ann", SessionRole::kViewer).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(roles.of("ann"), SessionRole::kOwner);
  EXPECT_TRUE(roles.set("bob", SessionRole::kOwner).is_ok());
  EXPECT_TRUE(roles.set("ann", SessionRole::kViewer).is_ok());
}

}  // namespace
}  // namespace burnish

#include "server/manager/caller.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

const SessionRoles kRoles({{"", SessionRole::kViewer}, {"ann", SessionRole::kOwner}});

TEST(Caller, ARefusalNamesUserRoleAndNeed) {
  EXPECT_TRUE(require_role(kRoles, "ann", SessionRole::kEditor, "editing").is_ok());
  const Status refused = require_role(kRoles, "bob", SessionRole::kEditor, "editing");
  EXPECT_EQ(refused.code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(refused.message(), "editing needs the role editor; 'bob' is viewer of this session");
}

TEST(Caller, IsInASessionAtMostWhatTheServerLetsThemBe) {
  Caller ann("ann");
  EXPECT_EQ(role_in(kRoles, ann), SessionRole::kOwner);
  ann.most = SessionRole::kViewer;
  EXPECT_EQ(role_in(kRoles, ann), SessionRole::kViewer);
}

TEST(Caller, WhoOwnsTheServerOwnsEverySession) {
  Caller otto("otto");
  EXPECT_EQ(role_in(kRoles, otto), SessionRole::kViewer);
  otto.owns_server = true;
  EXPECT_EQ(role_in(kRoles, otto), SessionRole::kOwner);
}

}  // namespace
}  // namespace burnish

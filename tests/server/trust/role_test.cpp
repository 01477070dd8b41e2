#include "server/trust/role.h"

#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"

namespace burnish {
namespace {

TEST(Roles, EveryRpcOfEveryServiceHasOne) {
  for (const auto* file :
       {v1::ListScansRequest::descriptor()->file(), v1::ApplyRequest::descriptor()->file()})
    for (int s = 0; s < file->service_count(); ++s)
      for (int m = 0; m < file->service(s)->method_count(); ++m) {
        const std::string method =
            "/" + file->service(s)->full_name() + "/" + file->service(s)->method(m)->name();
        const auto role = least_role(method);
        ASSERT_TRUE(role.has_value()) << method;
        EXPECT_GE(*role, Role::kViewer) << method;
      }
}

TEST(Roles, WhatIsInNoTableIsForNobody) {
  EXPECT_FALSE(least_role("/burnish.v1.Library/Format"));
  EXPECT_FALSE(least_role("/burnish.v1.Library/ListScans/"));
  EXPECT_FALSE(least_role(""));
}

TEST(Roles, AreReadByName) {
  for (const Role role : {Role::kViewer, Role::kEditor, Role::kOwner})
    EXPECT_EQ(parse_role(std::string(role_name(role))).value(), role);
  EXPECT_FALSE(parse_role("anyone").is_ok());
}

}  // namespace
}  // namespace burnish

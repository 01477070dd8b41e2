#include "server/rpc/reactor/references.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"

namespace burnish {
namespace {

using testing::HasSubstr;

template <typename Request>
std::string refusal_of_session(const std::string& name) {
  Request request;
  request.set_session(name);
  return check_references(request).message();
}

TEST(References, ASessionsNameIsCheckedInEveryRequest) {
  const std::string forged = "work\n[info] root logged in", endless(15 << 20, 'x');
  for (const auto& refusal :
       {refusal_of_session<v1::ExportRequest>, refusal_of_session<v1::GetStateRequest>,
        refusal_of_session<v1::ApplyRequest>, refusal_of_session<v1::Greeting>,
        refusal_of_session<v1::CellFieldsHeader>}) {
    EXPECT_THAT(refusal(forged), HasSubstr("the session's name or id has control characters"));
    EXPECT_THAT(refusal(endless), HasSubstr("has 15728640 bytes, the limit is 200"));
    EXPECT_EQ(refusal("work"), "");
  }
}

TEST(References, ASessionsNameInAGreetingIsChecked) {
  v1::WatchRequest request;
  request.mutable_greeting()->set_session("a\nb");
  EXPECT_THAT(check_references(request).message(), HasSubstr("control characters"));
}

TEST(References, AScansNameIsChecked) {
  v1::DescribeScanRequest request;
  request.set_scan("a\nb");
  EXPECT_THAT(check_references(request).message(), HasSubstr("the scan's name or id has control"));
}

TEST(References, ARequestThatNamesNothingPasses) {
  EXPECT_TRUE(check_references(v1::ListScansRequest()).is_ok());
}

}  // namespace
}  // namespace burnish

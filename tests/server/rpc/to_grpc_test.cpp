#include "server/rpc/transport/to_grpc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(ToGrpc, AShortStatusStaysAsItIs) {
  const grpc::Status status = to_grpc(not_found("no scan has the name 'M\u00fcller'"));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(status.error_message(), "no scan has the name 'M\u00fcller'");
  EXPECT_TRUE(to_grpc(Status::ok()).ok());
}

TEST(ToGrpc, ALongMessageIsCutBetweenTwoCharacters) {
  std::string long_name;
  while (long_name.size() < 15'000'000) long_name += "\u00fc";
  const std::string message = to_grpc(not_found("x" + long_name)).error_message();
  EXPECT_LT(message.size(), 1100u);
  EXPECT_THAT(message, testing::HasSubstr("\u00fc... ("));
}

TEST(ToGrpc, BytesThatAreNoUtf8AreNotSent) {
  EXPECT_EQ(to_grpc(not_found("M\xfcller")).error_message(), "M?ller");
}

}  // namespace
}  // namespace burnish

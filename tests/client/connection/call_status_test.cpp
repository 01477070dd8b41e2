#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/connection_state.h"
#include "tests/client/connection/fake_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

Status status_of(grpc::StatusCode code, const std::string& text) {
  return call_status("lab:7411", {code, text});
}

std::string lost(const std::string& text) {
  return status_of(grpc::StatusCode::UNAVAILABLE, text).message();
}

TEST(CallStatus, NamesTheServerAndKeepsItsOwnWords) {
  const Status status = status_of(grpc::StatusCode::NOT_FOUND, "no scan 'a'");
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_EQ(status.message(), "server lab:7411: no scan 'a'");
  EXPECT_THAT(lost("the server is going down"), HasSubstr("the server is going down"));
}

TEST(CallStatus, TurnsALostConnectionIntoWords) {
  for (const char* text : {"Socket closed", "recvmsg:Connection reset by peer", "GOAWAY received"})
    EXPECT_EQ(lost(text), "server lab:7411: the connection is lost") << text;
}

TEST(CallStatus, TurnsAServerThatIsNotReachedIntoWords) {
  const std::string dns =
      "DNS resolution failed for lab:7411: C-ares status is not ARES_SUCCESS qtype=A";
  EXPECT_THAT(lost(dns), HasSubstr("no computer has this name"));
  EXPECT_THAT(lost(dns), Not(HasSubstr("ARES")));
  const std::string all =
      "failed to connect to all addresses; last error: UNKNOWN: ipv4:1.2.3.4:1: ";
  EXPECT_THAT(lost(all + "Failed to connect to remote host: Connection refused"),
              HasSubstr("nothing listens there"));
  EXPECT_THAT(lost(all + "Socket closed"), HasSubstr("TLS"));
  EXPECT_THAT(lost(all + "Ssl handshake failed: SSL_ERROR_SSL: wrong version number"),
              HasSubstr("does not speak TLS"));
}

TEST(CallStatus, LeavesAnUnknownTextAsItIs) {
  EXPECT_EQ(no_link_words("something new"), "something new");
}

TEST(CallStatus, AServerWithoutTheCallIsOfAnotherVersion) {
  FakeLibrary library;  // which has no ProposeEdges
  auto connection = Connection::open(library.address(), std::chrono::seconds(120)).value();
  const Status refused = connection.propose_edges("ball", {}).status();
  EXPECT_EQ(refused.code(), StatusCode::kUnimplemented);
  EXPECT_THAT(refused.message(), HasSubstr("a version without this call"));
}

}  // namespace
}  // namespace burnish

// The web gateway and strangers: foreign pages, rebound names, wrong tokens, broken requests.

#include <fstream>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/library.grpc.pb.h"
#include "common/base/text.h"
#include "server/trust/users.h"
#include "tests/server/metrics/http_get.h"
#include "tests/system/web_client.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

size_t occurrences(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Returns the server's largest resident memory so far; proc(5).
uint64_t peak_bytes(const ServerProcess& server) {
  std::ifstream status("/proc/" + std::to_string(server.process->pid()) + "/status");
  std::string word;
  uint64_t kib = 0;
  while (status >> word && word != "VmHWM:") {
  }
  status >> kib;
  return kib * 1024;
}

std::string user_entry(const std::string& name, const std::string& role) {
  const TokenHash hash = hash_token(name + "-secret");
  return "[[user]]\nname = \"" + name + "\"\nrole = \"" + role + "\"\ntoken_sha256 = \"" +
         to_hex(std::as_bytes(std::span(hash))) + "\"\n";
}

/// A server with a gateway that knows vera (viewer) and eddy (editor) by "NAME-secret".
class WebRefusals : public testing::Test {
 protected:
  WebRefusals()
      : server_(
            {"--users",
             folder_
                 .write("users.toml", user_entry("vera", "viewer") + user_entry("eddy", "editor") +
                                          "[[user]]\nname = \"carl\"\nrole = \"owner\"\n"
                                          "certificate = \"carl\"\n")
                 .string(),
             "--web", "127.0.0.1:0", "--metrics", "127.0.0.1:0"}) {}

  double refusals(const std::string& reason) const {
    return metric(http_get_metrics(std::stoi(server_.announced("metrics on port "))),
                  "burnish_refusals_total{reason=\"" + reason + "\"}");
  }

  std::string address() const { return web_address(server_); }

  /// Returns the first line of the answer to a request with these headers.
  std::string status_line(const std::string& first_line, const std::string& headers) const {
    const std::string answer =
        http_exchange(address(), first_line + "\r\n" + headers + "Connection: close\r\n\r\n");
    return answer.substr(0, answer.find('\r'));
  }

  TemporaryFolder folder_;
  ServerProcess server_;
};

TEST_F(WebRefusals, APageOfAnotherOriginReachesNoSocket) {
  EXPECT_EQ(upgrade_status(address(), {.origin = "http://evil.test"}), 403);
  ASSERT_TRUE(server_.process->wait_for_output("the origin 'http://evil.test'", kPatience));
  EXPECT_EQ(occurrences(server_.process->output(), "evil.test"), 1u);
  EXPECT_EQ(refusals("origin"), 1);
}

TEST_F(WebRefusals, TheServersOwnPageReachesItsSocket) {
  EXPECT_EQ(upgrade_status(address(), {.origin = "http://" + address()}), 101);
}

TEST_F(WebRefusals, ANameThatWasReboundToThisMachineReachesNothing) {
  EXPECT_EQ(upgrade_status(address(), {.host = "evil.test", .origin = "http://evil.test"}), 403);
  EXPECT_EQ(status_line("GET / HTTP/1.1", "Host: evil.test\r\n"), "HTTP/1.1 403 Forbidden");
  EXPECT_EQ(status_line("GET / HTTP/1.1", ""), "HTTP/1.1 403 Forbidden");
  EXPECT_EQ(refusals("host"), 3);
  EXPECT_THAT(server_.process->output(), HasSubstr("web.hosts"));
}

TEST_F(WebRefusals, AConfiguredNameIsTaken) {
  const std::string config =
      folder_.write("server.toml", "[web]\nhosts = [\"burnish.lab\"]\n").string();
  const ServerProcess named({"--config", config, "--web", "127.0.0.1:0"});
  EXPECT_EQ(upgrade_status(web_address(named), {.host = "burnish.lab:7443"}), 101);
  EXPECT_EQ(upgrade_status(web_address(named), {.host = "burnish.test:7443"}), 403);
}

TEST_F(WebRefusals, TheMachinesOwnNameAndAGivenOneAreTaken) {
  char name[256] = {};
  ASSERT_EQ(gethostname(name, sizeof name - 1), 0);
  const ServerProcess named({"--web", "127.0.0.1:0", "--web-host", "burnish.lab"});
  for (const char* host : {static_cast<const char*>(name), "burnish.lab"})
    EXPECT_EQ(upgrade_status(web_address(named), {.host = std::string(host) + ":7443"}), 101)
        << host;
  EXPECT_EQ(upgrade_status(web_address(named), {.host = "burnish.test:7443"}), 403);
}

TEST_F(WebRefusals, EveryRpcIsClosedToStrangersAndNoTokenIsInTheLog) {
  WebClient client(address());
  double calls = 0;
  for (const std::string& method : all_rpcs())
    for (const std::string token : {"", "wrong-secret"}) {
      EXPECT_EQ(call(client, {method, {""}, token}).status.error_code(),
                grpc::StatusCode::UNAUTHENTICATED)
          << method;
      ++calls;
    }
  EXPECT_EQ(refusals("unauthenticated"), calls);
  EXPECT_THAT(server_.process->output(), HasSubstr("from ipv4:127.0.0.1:"));
  EXPECT_THAT(server_.process->output(), Not(HasSubstr("wrong-secret")));
}

TEST_F(WebRefusals, ATokenOpensTheCallsOfItsRole) {
  WebClient client(address());
  EXPECT_TRUE(call(client, {kListScansRpc, {""}, "vera-secret"}).status.ok());
  const grpc::Status status =
      call(client, {"/burnish.v1.Editing/Apply", {""}, "vera-secret"}).status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::PERMISSION_DENIED);
  EXPECT_THAT(status.error_message(), HasSubstr("user vera is viewer"));
  EXPECT_THAT(server_.process->output(), Not(HasSubstr("vera-secret")));
}

TEST_F(WebRefusals, ATokenThatGrpcWouldNotCarryClosesTheSocketAlone) {
  WebClient client(address());
  client.send_text(R"({"call":"burnish.v1.Library/ListScans","token":"vera\n-secret"})");
  EXPECT_FALSE(client.read());
  EXPECT_EQ(client.close_code(), 1002);
  WebClient next(address());
  EXPECT_TRUE(call(next, {kListScansRpc, {""}, "vera-secret"}).status.ok());
  EXPECT_THAT(server_.process->output(), Not(HasSubstr("-secret")));
}

TEST_F(WebRefusals, AStrangersMessagesCostNoMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer keeps memory that was given back";
#endif
  constexpr size_t kClients = 16, kMessageBytes = 15 << 20;
  const std::string half(kMessageBytes, 'x');
  std::vector<std::unique_ptr<WebClient>> strangers;
  for (size_t i = 0; i < kClients; ++i) {
    strangers.push_back(std::make_unique<WebClient>(address()));
    strangers.back()->send_text(begin_of(kListScansRpc));
    ASSERT_EQ(read_to_end(*strangers.back()).status.error_code(),
              grpc::StatusCode::UNAUTHENTICATED);
    ASSERT_TRUE(strangers.back()->send_part(half));  // the message has no end
  }
  WebClient user(address());
  ASSERT_TRUE(call(user, {kListScansRpc, {""}, "vera-secret"}).status.ok());
  EXPECT_LT(peak_bytes(server_), uint64_t{150} << 20);
}

TEST_F(WebRefusals, ACallThatIsOpenToAllHasShortMessages) {
  WebClient stranger(address());
  stranger.send_text(begin_of("/grpc.health.v1.Health/Check"));
  ASSERT_TRUE(stranger.send_part(std::string(600, 'x')));  // the message has no end
  EXPECT_EQ(read_to_end(stranger).status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_FALSE(stranger.read());
  EXPECT_EQ(stranger.close_code(), 1009);
}

TEST_F(WebRefusals, UnfinishedMessagesOfAllSocketsHaveALimit) {
  const std::string half(15 << 20, 'x');
  std::vector<std::unique_ptr<WebClient>> editors;
  for (int i = 0; i < 10; ++i) {
    editors.push_back(std::make_unique<WebClient>(address()));
    editors.back()->send_text(begin_of("/burnish.v1.Editing/Apply", "eddy-secret"));
    editors.back()->send_part(half);  // the message has no end
  }
  EXPECT_TRUE(server_.process->wait_for_output("all messages whose end has not come", kPatience));
  editors.clear();
  WebClient next(address());
  EXPECT_TRUE(call(next, {kListScansRpc, {""}, "eddy-secret"}).status.ok());
}

TEST_F(WebRefusals, AnotherUsersNameIsRefused) {
  WebClient client(address());
  client.send_text(
      R"({"call":"burnish.v1.Editing/OpenSession","token":"eddy-secret","user":"vera"})");
  client.send_message("\x0a\x04work");
  const grpc::Status status = read_to_end(client).status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::PERMISSION_DENIED);
}

TEST_F(WebRefusals, TheMarksOfTheGatewayCannotBeForgedOverGrpc) {
  grpc::ClientContext context;
  context.AddMetadata("burnish-gateway-secret", "guess");
  context.AddMetadata("burnish-gateway-peer", "ipv4:192.0.2.1:1");
  context.AddMetadata("burnish-gateway-certificate-bin", "carl");
  context.AddMetadata("burnish-certificate", "carl");
  const auto library = v1::Library::NewStub(wire_channel(server_.address));
  v1::ListScansResponse scans;
  EXPECT_EQ(library->ListScans(&context, {}, &scans).error_code(),
            grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_THAT(server_.process->output(), Not(HasSubstr("192.0.2.1")));
}

TEST_F(WebRefusals, NoPathReachesTheFileSystem) {
  const std::string host = "Host: " + address() + "\r\n";
  for (const char* target : {"/../../../../etc/passwd", "/assets/../../users.toml",
                             "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/index.html", "/data"})
    EXPECT_EQ(status_line(std::string("GET ") + target + " HTTP/1.1", host),
              "HTTP/1.1 404 Not Found")
        << target;
}

TEST_F(WebRefusals, BrokenRequestsAreAnsweredAndEndTheConnection) {
  const std::string host = "Host: " + address() + "\r\n";
  EXPECT_THAT(http_exchange(address(), "nonsense\r\n\r\n"), StartsWith("HTTP/1.1 400"));
  EXPECT_EQ(status_line("GET / HTTP/1.1", host + "Content-Length: 5\r\n"),
            "HTTP/1.1 413 Payload Too Large");
  EXPECT_EQ(status_line("GET / HTTP/1.1", host + "Transfer-Encoding: chunked\r\n"),
            "HTTP/1.1 413 Payload Too Large");
  EXPECT_EQ(status_line("POST / HTTP/1.1", host), "HTTP/1.1 405 Method Not Allowed");
  EXPECT_EQ(status_line("GET /rpc HTTP/1.1", host), "HTTP/1.1 426 Upgrade Required");
  EXPECT_THAT(status_line("GET / HTTP/1.1", host + "X: " + std::string(9000, 'x') + "\r\n"),
              HasSubstr("431"));
  EXPECT_EQ(refusals("malformed"), 5);
}

TEST_F(WebRefusals, AnotherSubprotocolIsRefused) {
  EXPECT_EQ(upgrade_status(address(), {.protocol = "burnish.v2"}), 400);
  EXPECT_EQ(upgrade_status(address(), {.protocol = ""}), 400);
  EXPECT_EQ(upgrade_status(address(), {.target = "/other"}), 404);
}

TEST(WebExposure, PlainTextBeyondThisMachineIsRefusedUnlessSaidSo) {
  const TemporaryFolder folder;
  const std::string data = (folder / "data").string();
  Process refused(
      {BURNISH_SERVER_BINARY, "--listen", "127.0.0.1:0", "--web", "0.0.0.0:0", "--data", data},
      folder / "log");
  EXPECT_EQ(refused.wait(kPatience), 2);
  EXPECT_THAT(refused.output(), HasSubstr("web.listen = '0.0.0.0:0' is reachable"));
}

TEST(WebExposure, WithoutItsFlagThereIsNoGateway) {
  const ServerProcess server;
  EXPECT_THAT(server.process->output(), Not(HasSubstr("web on")));
}

}  // namespace
}  // namespace burnish

// The rights of strangers and users over a real connection.

#include "server/trust/users.h"

#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "server/trust/role.h"
#include "tests/server/metrics/http_get.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char kListScansMethod[] = "/burnish.v1.Library/ListScans";

std::string hex(const TokenHash& hash) {
  std::string text;
  char digits[3];
  for (const unsigned char byte : hash) {
    std::snprintf(digits, sizeof(digits), "%02x", byte);
    text += digits;
  }
  return text;
}

std::string user(const std::string& name, const std::string& role, const std::string& token) {
  return "[[user]]\nname = \"" + name + "\"\nrole = \"" + role + "\"\ntoken_sha256 = \"" +
         hex(hash_token(token)) + "\"\n";
}

/// A server that knows vera (viewer), eddy (editor) and otto (owner) by "NAME-secret".
class UsersTest : public testing::Test {
 protected:
  UsersTest() {
    server_.kill();
    const auto users = folder_.write("users.toml", user("vera", "viewer", "vera-secret") +
                                                       user("eddy", "editor", "eddy-secret") +
                                                       user("otto", "owner", "otto-secret"));
    server_.flags = {"--users", users.string(), "--metrics", "127.0.0.1:0", "--log-format", "json"};
    server_.start();
    channel_ = wire_channel(server_.address);
  }

  grpc::Status list_as(const std::string& token) {
    return call(channel_, {kListScansMethod, {""}, token}).status;
  }

  double refusals(const std::string& reason) const {
    return metric(http_get_metrics(std::stoi(server_.announced("metrics on port "))),
                  "burnish_refusals_total{reason=\"" + reason + "\"}");
  }

  TemporaryFolder folder_;
  ServerProcess server_;
  std::shared_ptr<grpc::Channel> channel_;
};

TEST_F(UsersTest, EveryRpcIsClosedToStrangers) {
  const auto methods = all_rpcs();
  ASSERT_GE(methods.size(), 13u);
  for (const std::string& method : methods) {
    EXPECT_EQ(call(channel_, {method, {""}}).status.error_code(), grpc::StatusCode::UNAUTHENTICATED)
        << method;
    EXPECT_EQ(call(channel_, {method, {""}, "wrong-secret"}).status.error_code(),
              grpc::StatusCode::UNAUTHENTICATED)
        << method;
  }
  EXPECT_THAT(server_.process->output(), HasSubstr("refused " + methods.front() + ": "));
  EXPECT_EQ(refusals("unauthenticated"), 2.0 * static_cast<double>(methods.size()));
  EXPECT_THAT(server_.process->output(), Not(HasSubstr("wrong-secret")));
}

TEST_F(UsersTest, EveryRpcAsksForItsRole) {
  double refused = 0;
  for (const std::string& method : all_rpcs())
    for (const Role role : {Role::kViewer, Role::kEditor}) {
      if (role >= least_role(method).value()) continue;
      const std::string token = role == Role::kViewer ? "vera-secret" : "eddy-secret";
      const grpc::Status status = call(channel_, {method, {""}, token}).status;
      EXPECT_EQ(status.error_code(), grpc::StatusCode::PERMISSION_DENIED) << method;
      EXPECT_THAT(status.error_message(), HasSubstr(method + " needs the role"));
      ++refused;
    }
  EXPECT_GE(refused, 9);
  EXPECT_EQ(refusals("permission"), refused);
  EXPECT_TRUE(list_as("vera-secret").ok());
}

TEST_F(UsersTest, AViewerMayAskHowEdgesOfAScanAreKept) {
  const std::string token = folder_.write("token", "otto-secret").string();
  const CommandOutcome imported =
      server_.burnish({"import", write_sphere(folder_), "--name", "ball", "--token-file", token});
  ASSERT_EQ(imported.exit_code, 0) << imported.output;
  const std::string ball =
      "\x0a\x04"
      "ball";
  const std::string method = "/burnish.v1.Library/ProposeEdges";
  const WireAnswer answer = call(channel_, {method, {ball}, "vera-secret"});
  EXPECT_TRUE(answer.status.ok()) << answer.status.error_message();
  EXPECT_FALSE(answer.messages.empty());
}

TEST_F(UsersTest, AnUnknownRpcIsRefusedEvenToTheOwner) {
  for (const char* method : {"/burnish.v1.Library/Format", "/nonsense", "/a.B/C"})
    EXPECT_EQ(call(channel_, {method, {""}, "otto-secret"}).status.error_code(),
              grpc::StatusCode::UNIMPLEMENTED)
        << method;
}

TEST_F(UsersTest, HealthNeedsNoToken) {
  const WireAnswer answer = call(channel_, {"/grpc.health.v1.Health/Check", {""}});
  EXPECT_TRUE(answer.status.ok());
}

TEST_F(UsersTest, TheCommandLineTakesItsTokenFromAFile) {
  const std::string token = folder_.write("token", "vera-secret\n").string();
  EXPECT_THAT(server_.burnish({"meshes"}).output, HasSubstr("has no token and no certificate"));
  EXPECT_EQ(server_.burnish({"meshes", "--token-file", token}).exit_code, 0);
  const CommandOutcome refused =
      server_.burnish({"close", "work", "--delete", "--token-file", token});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("user vera is viewer"));
}

TEST_F(UsersTest, NobodyCallsHimselfAnother) {
  const std::string token = folder_.write("token", "eddy-secret").string();
  const CommandOutcome refused =
      server_.burnish({"open", "ball", "--user", "otto", "--token-file", token});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("user eddy must not use the name 'otto'"));
  EXPECT_THAT(server_.burnish({"open", "ball", "--user", "eddy", "--token-file", token}).output,
              HasSubstr("no scan has the name or id 'ball'"));
}

TEST_F(UsersTest, AChangedFileCountsWithoutARestart) {
  EXPECT_FALSE(list_as("nina-secret").ok());
  folder_.write("users.toml", user("nina", "viewer", "nina-secret"));
  server_.process->signal(SIGHUP);
  ASSERT_TRUE(server_.process->wait_for_output("users read again", kPatience));
  EXPECT_TRUE(list_as("nina-secret").ok());
  EXPECT_EQ(list_as("vera-secret").error_code(), grpc::StatusCode::UNAUTHENTICATED);
}

TEST_F(UsersTest, AChangeIsSeenWithoutASignalAndABrokenOneChangesNothing) {
  folder_.write("users.toml", "[[user]]\nname = \"half");
  ASSERT_TRUE(server_.process->wait_for_output("users are unchanged", kPatience));
  EXPECT_TRUE(list_as("vera-secret").ok());
}

TEST_F(UsersTest, JsonLinesCarryTheRequestsId) {
  call(channel_, {"/burnish.v1.Library/DescribeScan", {"\x0a\x04none"}, "vera-secret"});
  const std::string found = "NOT_FOUND after";
  ASSERT_TRUE(server_.process->wait_for_output(found, kPatience));
  const std::string log = server_.process->output();
  const size_t ended = log.find(found);
  const size_t begin = log.rfind('\n', ended) + 1;
  const auto line = nlohmann::json::parse(log.substr(begin, log.find('\n', ended) - begin));
  EXPECT_EQ(line["request"].get<std::string>().size(), 16u);
  EXPECT_EQ(line["level"], "info");
}

TEST(Plaintext, BeyondThisMachineIsRefusedUnlessSaidSo) {
  const TemporaryFolder folder;
  const std::string data = (folder / "data").string();
  Process refused({BURNISH_SERVER_BINARY, "--listen", "0.0.0.0:0", "--data", data}, folder / "log");
  EXPECT_EQ(refused.wait(kPatience), 2);
  EXPECT_THAT(refused.output(), HasSubstr("is reachable from other machines, in plain text"));
  Process meant({BURNISH_SERVER_BINARY, "--listen", "0.0.0.0:0", "--data", data, "--insecure"},
                folder / "log2");
  EXPECT_TRUE(meant.wait_for_output("listening on 0.0.0.0:", kPatience)) << meant.output();
}

TEST(Plaintext, ATokenIsNotSentToAnotherMachine) {
  const TemporaryFolder folder;
  const std::string token = folder.write("token", "secret").string();
  Process client({BURNISH_BINARY, "meshes", "--server", "192.0.2.1:7411", "--token-file", token},
                 folder / "log");
  EXPECT_EQ(client.wait(kPatience), 1);
  EXPECT_THAT(client.output(), HasSubstr("the token would travel to 192.0.2.1:7411 in plain text"));
}

}  // namespace
}  // namespace burnish

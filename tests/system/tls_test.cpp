// TLS between real processes: trust, and certificates that change while the processes run.

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/metrics/http_get.h"
#include "tests/server/trust/test_certificates.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class TlsTest : public testing::Test {
 protected:
  /// Writes a private key that only its owner can read.
  std::filesystem::path write_key(const std::string& name, const std::string& pem) const {
    const auto path = folder_.write(name, pem);
    std::filesystem::permissions(path, std::filesystem::perms(0600));
    return path;
  }

  /// Writes the server's certificate to the place where the server reads it.
  void install(const TestCa& ca, int days = 30) {
    const TestCa::Issued issued = ca.issue("server", days);
    write_key("new.key", issued.key);
    folder_.write("new.pem", issued.certificate);
    std::filesystem::rename(folder_ / "new.key", folder_ / "server.key");
    std::filesystem::rename(folder_ / "new.pem", folder_ / "server.pem");
  }

  std::unique_ptr<ServerProcess> start(std::vector<std::string> more = {}) const {
    std::vector<std::string> flags = {"--tls-certificate", (folder_ / "server.pem").string(),
                                      "--tls-key",         (folder_ / "server.key").string(),
                                      "--metrics",         "127.0.0.1:0"};
    flags.insert(flags.end(), more.begin(), more.end());
    return std::make_unique<ServerProcess>(flags);
  }

  std::unique_ptr<ServerProcess> start_with_client_ca() const {
    return start({"--tls-client-ca", folder_.write("ca.pem", ca_.certificate()).string(), "--users",
                  folder_
                      .write("users.toml",
                             "[[user]]\nname = \"anna\"\nrole = \"viewer\"\n"
                             "certificate = \"anna\"\n")
                      .string()});
  }

  /// Runs `burnish meshes`, which trusts this CA.
  CommandOutcome meshes(ServerProcess& server, const TestCa& ca,
                        std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"meshes", "--timeout", "30", "--tls-ca",
                                      folder_.write("trusted.pem", ca.certificate()).string()};
    words.insert(words.end(), more.begin(), more.end());
    return server.burnish(words);
  }

  CommandOutcome meshes_as(ServerProcess& server, const TestCa::Issued& client) const {
    return meshes(server, ca_,
                  {"--tls-certificate", folder_.write("client.pem", client.certificate).string(),
                   "--tls-key", folder_.write("client.key", client.key).string()});
  }

  static double handshakes_refused(const ServerProcess& server) {
    return metric(http_get_metrics(std::stoi(server.announced("metrics on port "))),
                  "burnish_refusals_total{reason=\"handshake\"}");
  }

  TestCa ca_{"our CA"}, other_ca_{"another CA"};
  TemporaryFolder folder_;
};

TEST_F(TlsTest, AClientThatKnowsTheCaConnects) {
  install(ca_);
  const auto server = start();
  const CommandOutcome outcome = meshes(*server, ca_);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}

TEST_F(TlsTest, AServerOfAnUnknownCaIsRefusedByTheClient) {
  install(ca_);
  const auto server = start();
  const CommandOutcome outcome = meshes(*server, other_ca_);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("certificate is not of an authority"));
}

TEST_F(TlsTest, AnExpiredServerIsRefusedByTheClient) {
  install(ca_, -1);
  const auto server = start();
  const CommandOutcome outcome = meshes(*server, ca_);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("certificate is not of an authority"));
}

TEST_F(TlsTest, PlaintextIsNoTls) {
  install(ca_);
  const auto server = start();
  EXPECT_EQ(server->burnish({"meshes", "--timeout", "30"}).exit_code, 1);
  EXPECT_GE(handshakes_refused(*server), 1);
}

TEST_F(TlsTest, ANewCertificateCountsWithoutARestart) {
  install(ca_);
  const auto server = start();
  const auto before = wire_channel(server->address, {ca_.certificate(), {}, {}});
  EXPECT_TRUE(call(before, {"/burnish.v1.Library/ListScans", {""}}).status.ok());
  install(other_ca_);
  server->process->signal(SIGHUP);
  ASSERT_TRUE(server->process->wait_for_output("certificates read again", kPatience));
  EXPECT_EQ(meshes(*server, other_ca_).exit_code, 0);
  EXPECT_EQ(meshes(*server, ca_).exit_code, 1);
  // Older connections continue.
  EXPECT_TRUE(call(before, {"/burnish.v1.Library/ListScans", {""}}).status.ok());
}

TEST_F(TlsTest, ABrokenCertificateLeavesTheOldOneInForce) {
  install(ca_);
  const auto server = start();
  folder_.write("server.pem", "not a certificate");
  ASSERT_TRUE(server->process->wait_for_output("certificates are unchanged", kPatience));
  EXPECT_EQ(meshes(*server, ca_).exit_code, 0);
  install(ca_);  // without a signal: the server sees the change
  EXPECT_TRUE(server->process->wait_for_output("certificates read again", kPatience));
}

TEST_F(TlsTest, AClientsCertificateSaysWhoItIs) {
  install(ca_);
  const auto server = start_with_client_ca();
  const CommandOutcome anna = meshes_as(*server, ca_.issue("anna"));
  EXPECT_EQ(anna.exit_code, 0) << anna.output;
  const CommandOutcome bert = meshes_as(*server, ca_.issue("bert"));
  EXPECT_EQ(bert.exit_code, 1);
  EXPECT_THAT(bert.output, HasSubstr("no user has the certificate 'bert'"));
}

TEST_F(TlsTest, ClientsWithoutAGoodCertificateAreRefusedLoggedAndCounted) {
  install(ca_);
  const auto server = start_with_client_ca();
  EXPECT_EQ(meshes_as(*server, ca_.issue("anna", -1)).exit_code, 1);
  EXPECT_TRUE(server->process->wait_for_output("refused a connection", kPatience));
  const double expired = handshakes_refused(*server);
  EXPECT_GE(expired, 1);
  EXPECT_EQ(meshes_as(*server, other_ca_.issue("anna")).exit_code, 1);
  const double unknown = handshakes_refused(*server);
  EXPECT_GT(unknown, expired);
  EXPECT_EQ(meshes(*server, ca_).exit_code, 1);
  EXPECT_GT(handshakes_refused(*server), unknown);
}

TEST_F(TlsTest, AKeyThatIsNotTheCertificatesStopsTheStart) {
  install(ca_);
  write_key("server.key", ca_.issue("other").key);
  Process server(
      {BURNISH_SERVER_BINARY, "--listen", "127.0.0.1:0", "--data", (folder_ / "data").string(),
       "--tls-certificate", (folder_ / "server.pem").string(), "--tls-key",
       (folder_ / "server.key").string()},
      folder_ / "log");
  EXPECT_EQ(server.wait(kPatience), 1);
  EXPECT_THAT(server.output(), HasSubstr("is not the key of"));
}

TEST_F(TlsTest, AKeyThatEverybodyReadsStopsTheStartWithItsMode) {
  install(ca_);
  std::filesystem::permissions(folder_ / "server.key", std::filesystem::perms(0644));
  Process server(
      {BURNISH_SERVER_BINARY, "--listen", "127.0.0.1:0", "--data", (folder_ / "data").string(),
       "--tls-certificate", (folder_ / "server.pem").string(), "--tls-key",
       (folder_ / "server.key").string()},
      folder_ / "log");
  EXPECT_EQ(server.wait(kPatience), 1);
  EXPECT_THAT(server.output(), HasSubstr("server.key can be read or written by everybody: its "
                                         "mode is 0644"));
}

TEST(UnixSocket, ServesBesideTcp) {
  const TemporaryFolder folder;
  const std::string path = (folder / "s").string();
  ServerProcess server({"--socket", path});
  EXPECT_EQ(server.burnish({"meshes"}).exit_code, 0);
  server.address = "unix:" + path;
  EXPECT_EQ(server.burnish({"meshes"}).exit_code, 0);
  server.process->signal(SIGTERM);
  EXPECT_EQ(server.process->wait(kPatience), 0);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace burnish

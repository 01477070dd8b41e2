// The web gateway with TLS: the same certificates as gRPC.

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/metrics/http_get.h"
#include "tests/server/trust/test_certificates.h"
#include "tests/system/web_client.h"

namespace burnish {
namespace {

class WebTls : public testing::Test {
 protected:
  WebTls() { install(ca_); }

  std::string write_key(const std::string& name, const std::string& pem) const {
    const auto path = folder_.write(name, pem);
    std::filesystem::permissions(path, std::filesystem::perms(0600));
    return path.string();
  }

  void install(const TestCa& ca) {
    const TestCa::Issued issued = ca.issue("server", 30);
    write_key("new.key", issued.key);
    folder_.write("new.pem", issued.certificate);
    std::filesystem::rename(folder_ / "new.key", folder_ / "server.key");
    std::filesystem::rename(folder_ / "new.pem", folder_ / "server.pem");
  }

  std::unique_ptr<ServerProcess> start(std::vector<std::string> more = {}) const {
    std::vector<std::string> flags = {"--tls-certificate",
                                      (folder_ / "server.pem").string(),
                                      "--tls-key",
                                      (folder_ / "server.key").string(),
                                      "--metrics",
                                      "127.0.0.1:0",
                                      "--web",
                                      "127.0.0.1:0"};
    flags.insert(flags.end(), more.begin(), more.end());
    return std::make_unique<ServerProcess>(flags);
  }

  TestCa ca_{"our CA"}, other_ca_{"another CA"};
  TemporaryFolder folder_;
};

TEST_F(WebTls, ACallGoesThrough) {
  const auto server = start();
  EXPECT_EQ(server->announced("web on ").substr(0, 8), "https://");
  WebClient client(web_address(*server),
                   {.ca = ca_.certificate(), .origin = "https://" + web_address(*server)});
  ASSERT_TRUE(client.is_open());
  EXPECT_TRUE(call(client, {kListScansRpc, {""}}).status.ok());
  client.close();
}

TEST_F(WebTls, APlainPagesOriginIsRefused) {
  const auto server = start();
  const WebClient client(web_address(*server),
                         {.ca = ca_.certificate(), .origin = "http://" + web_address(*server)});
  EXPECT_FALSE(client.is_open());
}

TEST_F(WebTls, PlainTextIsRefusedAndCounted) {
  const auto server = start();
  EXPECT_FALSE(WebClient(web_address(*server)).is_open());
  EXPECT_EQ(metric(http_get_metrics(std::stoi(server->announced("metrics on port "))),
                   "burnish_refusals_total{reason=\"handshake\"}"),
            1);
}

TEST_F(WebTls, ANewCertificateCountsWithoutARestart) {
  const auto server = start();
  WebClient before(web_address(*server), {.ca = ca_.certificate()});
  install(other_ca_);
  server->process->signal(SIGHUP);
  ASSERT_TRUE(server->process->wait_for_output("certificates read again", kPatience));
  EXPECT_FALSE(WebClient(web_address(*server), {.ca = ca_.certificate()}).is_open());
  WebClient after(web_address(*server), {.ca = other_ca_.certificate()});
  EXPECT_TRUE(call(after, {kListScansRpc, {""}}).status.ok());
  EXPECT_TRUE(call(before, {kListScansRpc, {""}}).status.ok());  // older sockets continue
}

TEST_F(WebTls, AClientsCertificateSaysWhoItIsAsOverGrpc) {
  const std::string users =
      folder_
          .write("users.toml",
                 "[[user]]\nname = \"anna\"\nrole = \"viewer\"\ncertificate = \"anna\"\n")
          .string();
  const auto server = start(
      {"--users", users, "--tls-client-ca", folder_.write("ca.pem", ca_.certificate()).string()});
  const TestCa::Issued anna = ca_.issue("anna"), bert = ca_.issue("bert");
  const auto status_as = [&](const TestCa::Issued& who, const std::string& method) {
    WebClient client(web_address(*server),
                     {.ca = ca_.certificate(), .certificate = who.certificate, .key = who.key});
    return call(client, {method, {""}}).status.error_code();
  };
  EXPECT_EQ(status_as(anna, kListScansRpc), grpc::StatusCode::OK);
  EXPECT_EQ(status_as(anna, "/burnish.v1.Editing/Apply"), grpc::StatusCode::PERMISSION_DENIED);
  EXPECT_EQ(status_as(bert, kListScansRpc), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_FALSE(WebClient(web_address(*server), {.ca = ca_.certificate()}).is_open());
}

}  // namespace
}  // namespace burnish

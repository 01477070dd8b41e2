// deploy/haproxy.cfg before the web gateway: TLS ends at the proxy, WebSockets pass.

#include <fstream>
#include <regex>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/trust/test_certificates.h"
#include "tests/system/web_client.h"

namespace burnish {
namespace {

constexpr char kHaproxy[] = "/usr/sbin/haproxy";

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  const std::regex searched(pattern, std::regex::multiline);
  EXPECT_TRUE(std::regex_search(text, searched)) << pattern;
  return std::regex_replace(text, searched, by);
}

/// Returns a port that nobody listened on a moment ago.
std::string free_port() {
  const ServerProcess server;
  return server.address.substr(server.address.rfind(':') + 1);
}

/// The installed configuration with other places of files and sockets.
std::string proxy_config(const TemporaryFolder& folder, const std::string& port,
                         const std::string& gateway) {
  std::ostringstream text;
  text << std::ifstream(SOURCE_ROOT "/deploy/haproxy.cfg").rdbuf();
  const std::string certificate = (folder / "proxy.pem").string();
  std::string config = replaced(text.str(), "^  user haproxy\n  group burnish$", "");
  config = replaced(config, "^  bind :7411 ssl crt \\S+",
                    "  bind unix@" + (folder / "grpc.sock").string() + " ssl crt " + certificate);
  config = replaced(config, "^  bind :7443 ssl crt \\S+",
                    "  bind 127.0.0.1:" + port + " ssl crt " + certificate);
  return replaced(config, "^  server gateway \\S+", "  server gateway " + gateway);
}

TEST(WebProxy, PagesAndSocketsPass) {
  if (!std::filesystem::exists(kHaproxy)) GTEST_SKIP() << "haproxy is not installed";
  const TemporaryFolder folder;
  const TestCa ca("our CA");
  const TestCa::Issued issued = ca.issue("server");
  folder.write("proxy.pem", issued.certificate + issued.key);
  const std::string config =
      folder.write("server.toml", "[web]\nhosts = [\"burnish.lab\"]\n").string();
  const ServerProcess server({"--config", config, "--web", "127.0.0.1:0"});
  const std::string address = "127.0.0.1:" + free_port();
  const Process proxy(
      {kHaproxy, "-db", "-f",
       folder
           .write("haproxy.cfg",
                  proxy_config(folder, address.substr(address.find(':') + 1), web_address(server)))
           .string()},
      folder / "proxy.log");
  const WebClientOptions options{
      .ca = ca.certificate(), .host = "burnish.lab", .origin = "https://burnish.lab"};
  std::optional<WebClient> client;
  for (int i = 0; i < 500 && !(client && client->is_open()); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // the proxy starts
    client.emplace(address, options);
  }
  ASSERT_TRUE(client->is_open()) << proxy.output();
  EXPECT_TRUE(call(*client, {kListScansRpc, {""}}).status.ok());
  const WebClient foreign(address, {.ca = ca.certificate(), .host = "evil.test"});
  EXPECT_FALSE(foreign.is_open());
}

}  // namespace
}  // namespace burnish

// A fleet behind HAProxy, with deploy/haproxy-fleet.cfg: clients know one address.

#include <filesystem>
#include <map>
#include <regex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/session_link.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/system/fetched_pages.h"
#include "tests/system/fleet_config.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

constexpr char kHaproxy[] = "/usr/sbin/haproxy";

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  const std::regex searched(pattern, std::regex::multiline);
  EXPECT_TRUE(std::regex_search(text, searched)) << pattern;
  return std::regex_replace(text, searched, by);
}

/// Two servers that advertise no address, and the proxy before them.
class FleetEdge : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kHaproxy)) GTEST_SKIP() << "haproxy is not installed";
    for (const char* name : {"one", "two"})
      servers_[name] = std::make_unique<ServerProcess>(
          fleet_flags(folder_, {.name = name, .journal = uri_, .shared = shared_.path()}));
    start_proxy();
    EXPECT_EQ(one()
                  .burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                  .exit_code,
              0);
    EXPECT_EQ(one().burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  }

  void start_proxy() {
    std::string config = content_of(SOURCE_ROOT "/deploy/haproxy-fleet.cfg");
    config = replaced(config, "^  bind :7411 ssl crt \\S+ alpn h2",
                      "  bind unix@" + edge_.substr(5) + " proto h2");
    config = replaced(config, "^  server one \\S+", "  server one " + one().address);
    config = replaced(config, "^  server two \\S+", "  server two " + two().address);
    config = replaced(config, "^  server three \\S+\n", "");
    proxy_ = std::make_unique<Process>(
        std::vector<std::string>{kHaproxy, "-db", "-f",
                                 folder_.write("haproxy.cfg", config).string()},
        folder_ / "proxy.log");
  }

  /// Returns a connection to the fleet. The proxy may be on its way up.
  Connection connect() {
    for (int tries = 0; tries < 500; ++tries) {
      auto connection = Connection::open(edge_, kPatience);
      if (connection.is_ok() && connection->list_scans().is_ok()) return std::move(*connection);
      std::this_thread::sleep_for(milliseconds(20));
    }
    ADD_FAILURE() << proxy_->output();
    std::abort();
  }

  ServerProcess& one() { return *servers_["one"]; }
  ServerProcess& two() { return *servers_["two"]; }

  std::vector<std::string> history() {
    Connection connection = connect();
    std::vector<std::string> ids;
    const std::vector<HistoryEntry> history = connection.history("work").value();
    for (const HistoryEntry& entry : history) ids.push_back(entry.edit_id);
    return ids;
  }

  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  const TemporaryFolder folder_, shared_;
  const std::string edge_ = "unix:" + (folder_ / "edge.sock").string();
  std::map<std::string, std::unique_ptr<ServerProcess>> servers_;
  std::unique_ptr<Process> proxy_;
};

TEST_F(FleetEdge, EachCallReachesTheServerThatHasTheSession) {
  for (int i = 0; i < 6; ++i) {  // the proxy chooses the first server of each
    Connection connection = connect();
    const Edit edit{std::to_string(i), SetGradientScale{0.1 * i}};
    const auto applied = connection.apply("work", {&edit, 1});
    ASSERT_TRUE(applied.is_ok()) << applied.status().message();
  }
  EXPECT_EQ(history(), (std::vector<std::string>{"0", "1", "2", "3", "4", "5"}));
}

TEST_F(FleetEdge, ALiveSessionGoesOnThroughTheSameAddressWhenItsServerIsKilled) {
  Connection connection = connect();
  const FetchedPages pages = fetch_all_pages(connection, "ball");
  LiveOptions options = pages.live_options("work", 4);
  options.retry_after_min = milliseconds(20);
  options.retry_after_max = milliseconds(200);
  SessionLink link(connection, options);
  std::vector<std::string> sent;
  const auto slide = [&](int number) {
    sent.push_back(std::to_string(number));
    ASSERT_TRUE(link.apply({Edit{sent.back(), SetGradientScale{0.01 * number}}}).is_ok());
  };
  for (int i = 1; i <= 5; ++i) slide(i);
  ASSERT_TRUE(link.wait_until_acknowledged(kPatience));
  one().kill();
  for (int i = 6; i <= 10; ++i) slide(i);
  ASSERT_TRUE(link.wait_until_acknowledged(kPatience)) << "the other server takes them";
  EXPECT_EQ(history(), sent);
}

}  // namespace
}  // namespace burnish

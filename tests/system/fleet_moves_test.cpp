// Clients of a fleet whose sessions move from server to server: they follow by themselves.

#include <csignal>
#include <fstream>
#include <map>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/session_link.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/server/prepare/sheets/photo_archive.h"
#include "tests/system/fetched_pages.h"
#include "tests/system/live_stream.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// Two servers that tell clients where they are, with a scan each, and a session "work" that the
/// first one has.
class FleetMoves : public testing::Test {
 protected:
  explicit FleetMoves(int lease_ms = 1500) : lease_ms_(lease_ms) {
    for (const char* name : {"one", "two"}) {
      write_config(name, "");
      servers_[name] =
          std::make_unique<ServerProcess>(std::vector<std::string>{"--config", config_of(name)});
      ServerProcess& server = *servers_[name];
      EXPECT_EQ(server.burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                    .exit_code,
                0);
      server.kill();  // the port is known now
      server.listen = server.address;
      write_config(name, server.address);
      server.start();
    }
    EXPECT_EQ(one().burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  }

  std::string config_of(const std::string& name) { return (folder_ / (name + ".toml")).string(); }
  /// Leases are short: the database has their clock, and the tests wait for it.
  void write_config(const std::string& name, const std::string& advertise) {
    std::ofstream file(config_of(name));
    file << "journal = \"" << uri_ << "\"\n[fleet]\nname = \"" << name
         << "\"\nlease_ms = " << lease_ms_ << "\nheartbeat_ms = " << lease_ms_ / 5 << "\n";
    if (!advertise.empty()) file << "advertise = \"" << advertise << "\"\n";
  }

  ServerProcess& one() { return *servers_["one"]; }
  ServerProcess& two() { return *servers_["two"]; }

  std::vector<std::string> history_at(ServerProcess& server) {
    Connection connection = Connection::open(server.address, kPatience).value();
    const std::vector<HistoryEntry> history = connection.history("work").value();
    std::vector<std::string> ids;
    for (const HistoryEntry& entry : history) ids.push_back(entry.edit_id);
    return ids;
  }

  /// Returns whether a client that greets the server is told of both. Each tells what its last
  /// heartbeat has seen.
  bool tells_of_both(Connection& connection, const LiveOptions& options) {
    for (int tries = 0; tries < 1000; ++tries) {
      SessionLink link(connection, options);
      for (bool is_greeted = false; !is_greeted;) {
        for (const LiveEvent& event : link.take().events)
          if (const auto* welcome = std::get_if<Welcome>(&event)) {
            is_greeted = true;
            if (welcome->fleet.size() == 2) return true;
          }
        std::this_thread::sleep_for(milliseconds(10));
      }
    }
    return false;
  }

  const int lease_ms_;
  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  const TemporaryFolder folder_;
  std::map<std::string, std::unique_ptr<ServerProcess>> servers_;
};

TEST_F(FleetMoves, CallsGoWhereTheSessionIs) {
  Connection connection = Connection::open(two().address, kPatience).value();
  const Edit edit{"through-two", SetGradientScale{0.5}};
  const auto applied = connection.apply("work", {&edit, 1});
  ASSERT_TRUE(applied.is_ok()) << applied.status().message();
  EXPECT_EQ(connection.state("work").value().settings.beta, 0.5);
  EXPECT_EQ(connection.server(), two().address);
  EXPECT_THAT(history_at(one()), testing::ElementsAre("through-two"));
}

TEST_F(FleetMoves, EveryCommandWorksAtAnyServer) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"edit", "work", "--beta", "2"},
                                             {"history", "work"},
                                             {"people", "work"},
                                             {"export", "work", (folder_ / "out.ply").string()}}) {
    const CommandOutcome outcome = two().burnish(words);
    EXPECT_EQ(outcome.exit_code, 0) << words[0] << ": " << outcome.output;
  }
}

TEST_F(FleetMoves, LevelledSheetsComeFromWhereTheSessionIs) {
  const std::vector<uint8_t> zip = zip_of(PhotoGrid());
  std::ofstream(folder_ / "photos.zip", std::ios::binary)
      .write(reinterpret_cast<const char*>(zip.data()), static_cast<std::streamsize>(zip.size()));
  for (ServerProcess* server : {&one(), &two()})
    EXPECT_EQ(server->burnish({"import", (folder_ / "photos.zip").string(), "--name", "photos"})
                  .exit_code,
              0);
  EXPECT_EQ(one().burnish({"open", "photos", "--session", "level"}).exit_code, 0);
  Connection connection = Connection::open(two().address, kPatience).value();
  const Edit edit{"level", SetTexture{{.level_seams = 1}}};
  ASSERT_TRUE(connection.apply("level", {&edit, 1}).is_ok());
  const auto described = connection.describe_sheets("photos", {}, "level");
  ASSERT_TRUE(described.is_ok()) << described.status().message();
  EXPECT_NE(described->version, 0u);
  size_t sheets = 0;
  const auto ignored = [](const PagePart&) { return true; };
  const auto count = [&](const SheetPart&) { return ++sheets > 0; };
  const SheetsWish wish{"photos", {}, {}, {{0, 0}}, described->version};
  const Status fetched = connection.fetch_sheets(wish, {ignored, ignored, count});
  EXPECT_TRUE(fetched.is_ok()) << fetched.message();
  EXPECT_EQ(sheets, 1u);
  one().kill();
  Connection again = Connection::open(two().address, kPatience).value();
  const auto taken_over = again.describe_sheets("photos", {}, "level");
  ASSERT_TRUE(taken_over.is_ok()) << taken_over.status().message();
  EXPECT_EQ(taken_over->version, described->version);
  EXPECT_TRUE(again.fetch_sheets(wish, {ignored, ignored, count}).is_ok());
}

TEST_F(FleetMoves, ALiveLinkFollowsItsSessionAndLosesNoEdit) {
  Connection connection = Connection::open(one().address, kPatience).value();
  const FetchedPages pages = fetch_all_pages(connection, "ball");
  LiveOptions options = pages.live_options("work", 4);
  options.retry_after_min = milliseconds(20);
  options.retry_after_max = milliseconds(200);
  ASSERT_TRUE(tells_of_both(connection, options));
  SessionLink link(connection, options);
  ASSERT_TRUE(link.show_pages({pages.pages.back()}, {}).is_ok());
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
  EXPECT_EQ(history_at(two()), sent);
  EXPECT_NE(link.take().link, LinkState::kEnded);
}

TEST_F(FleetMoves, ALiveLinkGreetsAnyServer) {
  Connection connection = Connection::open(two().address, kPatience).value();
  const FetchedPages pages = fetch_all_pages(connection, "ball");
  SessionLink link(connection, pages.live_options("work", 4));
  ASSERT_TRUE(link.apply({Edit{"from-afar", SetGradientScale{2}}}).is_ok());
  ASSERT_TRUE(link.wait_until_acknowledged(kPatience));
  EXPECT_THAT(history_at(one()), testing::ElementsAre("from-afar"));
}

TEST_F(FleetMoves, ADrainedServerSendsItsLiveClientsToAnother) {
  Connection connection = Connection::open(one().address, kPatience).value();
  const FetchedPages pages = fetch_all_pages(connection, "ball");
  ASSERT_TRUE(tells_of_both(connection, pages.live_options("work", 4)));
  SessionLink link(connection, pages.live_options("work", 4));
  ASSERT_TRUE(link.apply({Edit{"before", SetGradientScale{2}}}).is_ok());
  ASSERT_TRUE(link.wait_until_acknowledged(kPatience));
  one().process->signal(SIGTERM);
  ASSERT_TRUE(link.apply({Edit{"after", SetGradientScale{3}}}).is_ok());
  EXPECT_TRUE(link.wait_until_acknowledged(kPatience));
  EXPECT_EQ(one().process->wait(kPatience), 0);
  EXPECT_THAT(history_at(two()), testing::ElementsAre("before", "after"));
}

/// Nobody's lease ends while a test runs.
class FleetOfLongLeases : public FleetMoves {
 protected:
  FleetOfLongLeases() : FleetMoves(300'000) {}
};

TEST_F(FleetOfLongLeases, ADrainingServerNamesTheOneThatTakesItsSessionAtOnce) {
  LiveStream stream(grpc::CreateChannel(one().address, grpc::InsecureChannelCredentials()));
  stream.greet("work");
  stream.slide("before", 2);
  stream.next(v1::ServerMessage::kAcknowledged);
  one().process->signal(SIGTERM);
  const v1::GoAway go_away = stream.next(v1::ServerMessage::kGoAway).go_away();
  one().process->signal(SIGSTOP);  // it does not come to its end
  EXPECT_EQ(go_away.code(), v1::GO_AWAY_CODE_GOING_DOWN);
  EXPECT_TRUE(go_away.come_back());
  ASSERT_EQ(go_away.moved().address(), two().address);
  EXPECT_EQ(go_away.moved().node(), "two");
  Connection connection = Connection::open(go_away.moved().address(), kPatience).value();
  const Edit edit{"after", SetGradientScale{3}};
  const auto applied = connection.apply("work", {&edit, 1});
  EXPECT_TRUE(applied.is_ok()) << applied.status().message();
  EXPECT_EQ(connection.server(), two().address);
  EXPECT_THAT(history_at(two()), testing::ElementsAre("before", "after"));
}

}  // namespace
}  // namespace burnish

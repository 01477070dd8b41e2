// Servers that share a folder of scans: what one of them has imported opens on all.

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/system/fleet_config.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class FleetScans : public testing::Test {
 protected:
  FleetScans() {
    for (const char* name : {"one", "two"})
      servers_[name] = std::make_unique<ServerProcess>(
          fleet_flags(folder_, {.name = name, .journal = uri_, .shared = shared_.path()}));
    EXPECT_EQ(one()
                  .burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                  .exit_code,
              0);
  }

  ServerProcess& one() { return *servers_["one"]; }
  ServerProcess& two() { return *servers_["two"]; }

  std::string exported(ServerProcess& server) {
    const std::string file = (folder_ / "out.ply").string();
    const CommandOutcome outcome = server.burnish({"export", "work", file, "--exact"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    return content_of(file);
  }

  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  const TemporaryFolder folder_, shared_;
  std::map<std::string, std::unique_ptr<ServerProcess>> servers_;
};

TEST_F(FleetScans, AreListedAndOpenedByServersThatHaveNotImportedThem) {
  EXPECT_THAT(two().burnish({"meshes"}).output, HasSubstr("ball"));
  EXPECT_EQ(two().scans(), 0u);
  const CommandOutcome opened =
      two().burnish({"open", "ball", "--depth", "4", "--session", "work"});
  EXPECT_EQ(opened.exit_code, 0) << opened.output;
  EXPECT_EQ(two().scans(), 1u);
}

TEST_F(FleetScans, ASessionGoesOnWhereItsScanHasNeverBeen) {
  ASSERT_EQ(one().burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  ASSERT_EQ(one().burnish({"edit", "work", "--beta", "0.3"}).exit_code, 0);
  const std::string before = exported(one());
  one().kill();
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (two().burnish({"history", "work"}).exit_code != 0 &&
         std::chrono::steady_clock::now() < end) {
  }
  EXPECT_EQ(exported(two()), before);
}

TEST_F(FleetScans, ASessionThatHasNoRoomOpensOnTheServerWithTheMostRoom) {
  FleetServer roomy{.name = "one", .journal = uri_, .shared = shared_.path()};
  one().kill();
  one().listen = roomy.advertise = one().address;
  fleet_flags(folder_, roomy);
  one().start();
  two().kill();
  fleet_flags(folder_,
              {.name = "two", .journal = uri_, .shared = shared_.path(), .memory_bytes_max = 1});
  two().start();
  const CommandOutcome opened =
      two().burnish({"open", "ball", "--depth", "4", "--session", "work"});
  EXPECT_EQ(opened.exit_code, 0) << opened.output;
  EXPECT_THAT(two().burnish({"history", "work"}).exit_code, 0);
  Connection connection = Connection::open(one().address, kPatience).value();
  EXPECT_TRUE(connection.state("work").is_ok()) << "it is there";
}

TEST_F(FleetScans, AScanIsDeletedNowhereWhileASessionOfAnotherServerEditsIt) {
  ASSERT_EQ(one().burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  Connection connection = Connection::open(two().address, kPatience).value();
  const Status refused = connection.delete_scan("ball").status();
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("session work"));
  ASSERT_EQ(one().burnish({"close", "work", "--delete"}).exit_code, 0);
  EXPECT_TRUE(connection.delete_scan("ball").is_ok());
  EXPECT_THAT(one().burnish({"meshes"}).output, testing::Not(HasSubstr("ball")));
}

}  // namespace
}  // namespace burnish

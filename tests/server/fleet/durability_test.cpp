#include "server/fleet/durability.h"

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/postgres/postgres_cluster.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PgConnection connect(const PostgresCluster& cluster) {
  return PgConnection::open(PgAddress::parse(cluster.uri("postgres")).value(), {}, "test").value();
}

TEST(Durability, AOneHostDatabaseThatSyncsIsSilent) {
  const PostgresCluster cluster;
  PgConnection database = connect(cluster);
  EXPECT_THAT(*durability_warnings(database, false), testing::IsEmpty());
  EXPECT_THAT(*durability_warnings(database, true),
              ElementsAre(HasSubstr("synchronous_standby_names is empty")));
}

TEST(Durability, AStandbyThatNobodyWaitsForIsNamed) {
  PostgresCluster cluster("fsync=off");
  const PostgresCluster standby(cluster);
  PgConnection database = connect(cluster);
  while (database.run({"SELECT count(*) FROM pg_stat_replication", {}})->integer(0, 0) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_THAT(*durability_warnings(database, false),
              ElementsAre(HasSubstr("has 1 standbys"), HasSubstr("fsync is off")));
}

TEST(Durability, ACommitThatDoesNotWaitIsNamed) {
  const PostgresCluster cluster("synchronous_commit=local synchronous_standby_names=a");
  PgConnection database = connect(cluster);
  EXPECT_THAT(*durability_warnings(database, true),
              ElementsAre(HasSubstr("synchronous_commit is \"local\"")));
}

}  // namespace
}  // namespace burnish

// Servers that share a folder or a bucket of scans: what one of them has imported opens on all.

#include <future>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/server/s3/s3_service.h"
#include "tests/system/fleet_config.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A store of originals, and what a server's configuration says of it.
class Originals {
 public:
  explicit Originals(const std::string& kind) {
    if (kind == "Bucket") service_ = std::make_unique<S3Service>();
  }

  FleetServer server(const std::string& name, const std::string& journal,
                     const std::string& secret = S3Service::kSecret) const {
    FleetServer server{.name = name, .journal = journal, .shared = folder_.path()};
    if (!service_) return server;
    server.shared = service_->settings().uri;
    const auto file =
        folder_.write(name + ".ini", "aws_access_key_id = " + std::string(S3Service::kId) +
                                         "\naws_secret_access_key = " + secret + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    server.library = "s3_endpoint = \"" + service_->endpoint() + "\"\ns3_credentials = \"" +
                     file.string() + "\"\n";
    return server;
  }

  S3Service& service() { return *service_; }

 private:
  const TemporaryFolder folder_;
  std::unique_ptr<S3Service> service_;
};

class FleetScans : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (GetParam() == std::string("Bucket") && !S3Service::is_installed())
      GTEST_SKIP() << S3Service::kMissing;
    originals_ = std::make_unique<Originals>(GetParam());
    for (const char* name : {"one", "two"})
      servers_[name] =
          std::make_unique<ServerProcess>(fleet_flags(folder_, originals_->server(name, uri_)));
    ASSERT_EQ(one()
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
  const TemporaryFolder folder_;
  std::unique_ptr<Originals> originals_;
  std::map<std::string, std::unique_ptr<ServerProcess>> servers_;
};

INSTANTIATE_TEST_SUITE_P(Stores, FleetScans, testing::Values("Folder", "Bucket"),
                         [](const auto& store) { return std::string(store.param); });

TEST_P(FleetScans, AreListedAndOpenedByServersThatHaveNotImportedThem) {
  EXPECT_THAT(two().burnish({"meshes"}).output, HasSubstr("ball"));
  EXPECT_EQ(two().scans(), 0u);
  const CommandOutcome opened =
      two().burnish({"open", "ball", "--depth", "4", "--session", "work"});
  EXPECT_EQ(opened.exit_code, 0) << opened.output;
  EXPECT_EQ(two().scans(), 1u);
}

TEST_P(FleetScans, ASessionGoesOnWhereItsScanHasNeverBeen) {
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

TEST_P(FleetScans, ASessionThatHasNoRoomOpensOnTheServerWithTheMostRoom) {
  FleetServer roomy = originals_->server("one", uri_);
  FleetServer full = originals_->server("two", uri_);
  full.memory_bytes_max = 1;
  one().kill();
  one().listen = roomy.advertise = one().address;
  fleet_flags(folder_, roomy);
  one().start();
  two().kill();
  fleet_flags(folder_, full);
  two().start();
  const CommandOutcome opened =
      two().burnish({"open", "ball", "--depth", "4", "--session", "work"});
  EXPECT_EQ(opened.exit_code, 0) << opened.output;
  EXPECT_THAT(two().burnish({"history", "work"}).exit_code, 0);
  Connection connection = Connection::open(one().address, kPatience).value();
  EXPECT_TRUE(connection.state("work").is_ok()) << "it is there";
}

TEST_P(FleetScans, AScanIsDeletedNowhereWhileASessionOfAnotherServerEditsIt) {
  ASSERT_EQ(one().burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  Connection connection = Connection::open(two().address, kPatience).value();
  const Status refused = connection.delete_scan("ball").status();
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("session work"));
  ASSERT_EQ(one().burnish({"close", "work", "--delete"}).exit_code, 0);
  EXPECT_TRUE(connection.delete_scan("ball").is_ok());
  EXPECT_THAT(one().burnish({"meshes"}).output, Not(HasSubstr("ball")));
}

TEST_P(FleetScans, OneNameIsGivenOnceThoughTwoServersImportAtTheSameTime) {
  const auto import = [&](ServerProcess& server, int level) {
    return server.burnish(
        {"import", write_sphere(folder_, level), "--depth", "4", "--name", "twin"});
  };
  auto first = std::async(std::launch::async, [&] { return import(one(), 1); });
  const CommandOutcome second = import(two(), 2);
  const CommandOutcome outcomes[] = {first.get(), second};
  EXPECT_NE(outcomes[0].exit_code == 0, outcomes[1].exit_code == 0)
      << outcomes[0].output << outcomes[1].output;
  for (ServerProcess* server : {&one(), &two()})
    EXPECT_EQ(server->burnish({"describe", "twin"}).exit_code, 0);
}

class FleetBucket : public testing::Test {
 protected:
  void SetUp() override {
    if (!S3Service::is_installed()) GTEST_SKIP() << S3Service::kMissing;
    originals_ = std::make_unique<Originals>("Bucket");
  }

  /// Returns the last words of a server that does not start.
  std::string refusal_of(const FleetServer& server) {
    std::vector<std::string> words = {BURNISH_SERVER_BINARY, "--listen", "127.0.0.1:0", "--data",
                                      (folder_ / "data").string()};
    const std::vector<std::string> flags = fleet_flags(folder_, server);
    words.insert(words.end(), flags.begin(), flags.end());
    Process process(words, folder_ / "output");
    EXPECT_EQ(process.wait(kPatience), 1);
    return process.output();
  }

  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  const TemporaryFolder folder_;
  std::unique_ptr<Originals> originals_;
};

TEST_F(FleetBucket, ThatDoesNotExistStopsTheStart) {
  FleetServer server = originals_->server("one", uri_);
  server.shared = "s3://nowhere/lab";
  const std::string said = refusal_of(server);
  EXPECT_THAT(said, HasSubstr("library.shared = 's3://nowhere/lab' at " +
                              originals_->service().endpoint()));
  EXPECT_THAT(said, HasSubstr("NoSuchBucket"));
  EXPECT_THAT(said, HasSubstr("make the bucket"));
}

TEST_F(FleetBucket, WithAWrongSecretStopsTheStartAndTheLogHasNoSecret) {
  const std::string said = refusal_of(originals_->server("one", uri_, "another-secret"));
  EXPECT_THAT(said, HasSubstr("403 SignatureDoesNotMatch"));
  EXPECT_THAT(said, HasSubstr("credentials"));
  EXPECT_THAT(said, Not(HasSubstr("another-secret")));
}

TEST_F(FleetBucket, WithoutAServiceStopsTheStart) {
  originals_->service().kill();
  EXPECT_THAT(refusal_of(originals_->server("one", uri_)), HasSubstr("does it answer?"));
}

TEST_F(FleetBucket, ThatIsAwayRefusesImportsUntilItIsBack) {
  ServerProcess server(fleet_flags(folder_, originals_->server("one", uri_)));
  const std::string file = write_sphere(folder_);
  originals_->service().kill();
  const CommandOutcome away = server.burnish({"import", file, "--depth", "4", "--name", "ball"});
  EXPECT_NE(away.exit_code, 0);
  EXPECT_THAT(away.output, HasSubstr("sharing scan ball failed"));
  EXPECT_THAT(away.output, Not(HasSubstr(S3Service::kId)));
  EXPECT_EQ(server.staged() + server.scans(), 0u);
  originals_->service().start();
  const CommandOutcome back = server.burnish({"import", file, "--depth", "4", "--name", "ball"});
  EXPECT_EQ(back.exit_code, 0) << back.output;
  EXPECT_THAT(server.process->output(), Not(HasSubstr(S3Service::kSecret)));
}

}  // namespace
}  // namespace burnish

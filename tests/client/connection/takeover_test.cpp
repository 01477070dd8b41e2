// A killed server of a fleet: its sessions are asked for until another server has them.

#include <atomic>

#include <gtest/gtest.h>

#include "burnish/v1/editing.grpc.pb.h"
#include "client/connection/connection.h"
#include "tests/client/connection/fake_server.h"

namespace burnish {
namespace {

/// Sends callers to a server that has been killed, until it has the session itself.
class Survivor final : public v1::Editing::Service {
 public:
  explicit Survivor(std::string killed) : killed_(std::move(killed)) {}

  grpc::Status CloseSession(grpc::ServerContext*, const v1::CloseSessionRequest*,
                            v1::CloseSessionResponse*) override {
    if (++asked >= 3) return grpc::Status::OK;
    v1::Moved moved;
    moved.set_address(killed_);
    moved.set_node("one");
    return {grpc::StatusCode::FAILED_PRECONDITION, "server one holds the session",
            moved.SerializeAsString()};
  }

  std::atomic<int> asked{0};

 private:
  const std::string killed_;
};

/// Returns the address of a server that has been there.
std::string address_of_killed() {
  v1::Editing::Service none;
  int port = 0;
  serve_fake(none, port)->Shutdown();
  return "127.0.0.1:" + std::to_string(port);
}

TEST(Takeover, ACallWaitsUntilAnotherServerHasTheSession) {
  Survivor survivor(address_of_killed());
  int port = 0;
  const auto server = serve_fake(survivor, port);
  auto connection = Connection::open("127.0.0.1:" + std::to_string(port), std::chrono::seconds(60));
  ASSERT_TRUE(connection.is_ok()) << connection.status().message();
  const Status closed = connection->close_session("carving");
  EXPECT_TRUE(closed.is_ok()) << closed.message();
  EXPECT_EQ(survivor.asked, 3);
}

}  // namespace
}  // namespace burnish

#include "server/main/daemon.h"

#include <future>
#include <thread>

#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "server/live/live_sessions.h"
#include "server/manager/session_manager.h"
#include "server/scheduling/pools.h"
#include "tests/common/fast_clock.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

/// A plain server in this process.
struct TestServer {
  TemporaryFolder root;
  std::unique_ptr<DataFolder> folder = std::move(DataFolder::open(root / "data")).value();
  std::unique_ptr<MeshStore> opened_store = std::move(MeshStore::open(*folder, {})).value();
  MeshStore& store = *opened_store;
  std::unique_ptr<Journal> journal = std::move(SqliteJournal::open(folder->journal())).value();
  std::unique_ptr<SessionManager> sessions =
      std::move(SessionManager::create(*folder, store, *journal, {})).value();
  LiveSessions live{*sessions, 1};
  Pools pools{{}};
  std::unique_ptr<Server> server =
      std::move(Server::start({"127.0.0.1:0", {}}, store, *sessions, live, pools)).value();
};

/// Returns the answer of grpc.health.v1 for a service: "\x08\x01" is SERVING, "\x08\x02" is
/// NOT_SERVING.
std::string health(const Server& server, const std::string& service) {
  grpc::GenericStub stub(grpc::CreateChannel(server.address(), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const grpc::Slice slice("\x0a" + std::string(1, static_cast<char>(service.size())) + service);
  const auto call =
      stub.PrepareUnaryCall(&context, "/grpc.health.v1.Health/Check", {&slice, 1}, &queue);
  grpc::ByteBuffer answer;
  grpc::Status status;
  call->StartCall();
  call->Finish(&answer, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  queue.Next(&tag, &ok);
  grpc::Slice bytes;
  if (!status.ok() || !answer.DumpToSingleSlice(&bytes).ok()) return status.error_message();
  return {bytes.begin(), bytes.end()};
}

/// Waits until somebody is connected to a server, or nobody; false if that does not come about.
bool comes_to_be_in_use(const Server& server, bool in_use) {
  for (int i = 0; i < 30'000 && server.is_in_use() != in_use; ++i)
    std::this_thread::sleep_for(milliseconds(2));
  return server.is_in_use() == in_use;
}

TEST(Daemon, AFailedDeviceEndsItWithEveryServiceNotServing) {
  const sigset_t signals = block_signals();
  TestServer test;
  std::atomic<bool> works{true};
  const DeviceWatch device(
      [&works] { return works ? Status::ok() : internal_error("illegal address"); },
      {milliseconds(1), milliseconds(60'000)});
  std::atomic<int> rounds{0};
  auto end = std::async(std::launch::async, [&] {
    return watch_over(*test.server, device, signals,
                      {.tick = milliseconds(1), .tend = [&rounds](bool) { ++rounds; }});
  });
  EXPECT_EQ(health(*test.server, "burnish.v1.Library"), "\x08\x01");
  while (rounds < 3) std::this_thread::yield();  // it continues while all is well

  works = false;
  const Status status = end.get();
  EXPECT_EQ(status.message(), "the solver's device has failed: illegal address");
  for (const char* service : {"", "burnish.v1.Library", "burnish.v1.Editing"})
    EXPECT_EQ(health(*test.server, service), "\x08\x02") << service;
}

TEST(Daemon, EndsByItselfOnceNobodyIsConnectedForAWhile) {
  const sigset_t signals = block_signals();
  TestServer test;
  const DeviceWatch device([] { return Status::ok(); });
  EXPECT_FALSE(test.server->is_in_use());
  EXPECT_EQ(health(*test.server, ""), "\x08\x01");
  ASSERT_TRUE(comes_to_be_in_use(*test.server, false));  // it hears later that a channel closed
  FastClock clock;
  int rounds = 0;
  DaemonOptions options;
  options.idle_max = std::chrono::minutes(100);
  options.tick = milliseconds(1);
  options.clock = clock.clock();
  options.tend = [&](bool) {
    ++rounds;
    clock.put_forward(std::chrono::minutes(30));
  };
  EXPECT_TRUE(watch_over(*test.server, device, signals, options).is_ok());
  EXPECT_EQ(rounds, 4);  // at 0, 30, 60 and 90 minutes
}

TEST(Daemon, EndsWithItsOwner) {
  const sigset_t signals = block_signals();
  TestServer test;
  const DeviceWatch device([] { return Status::ok(); });
  int rounds = 0;
  DaemonOptions options;
  options.tick = milliseconds(1);
  options.tend = [&](bool) { ++rounds; };
  options.is_abandoned = [&] { return rounds == 3; };
  EXPECT_TRUE(watch_over(*test.server, device, signals, options).is_ok());
  EXPECT_EQ(rounds, 3);
}

TEST(Server, IsInUseWhileSomebodyIsConnected) {
  TestServer test;
  {
    const auto channel =
        grpc::CreateChannel(test.server->address(), grpc::InsecureChannelCredentials());
    ASSERT_TRUE(
        channel->WaitForConnected(std::chrono::system_clock::now() + std::chrono::seconds(60)));
    EXPECT_TRUE(comes_to_be_in_use(*test.server, true));
  }
  EXPECT_TRUE(comes_to_be_in_use(*test.server, false));
}

}  // namespace
}  // namespace burnish

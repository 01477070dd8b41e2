// Clients come and go, each in another way and at another moment; nothing of them may stay.
// BURNISH_CHURN=N makes N clients come and go instead of 300, beside 100 idle watchers instead
// of 10.

#include <iostream>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/library.pb.h"
#include "common/transfer/chunk.h"
#include "tests/server/metrics/http_get.h"
#include "tests/system/environment.h"
#include "tests/system/live_stream.h"
#include "tests/system/server_process.h"
#include "tests/system/steadiness.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Case = v1::ServerMessage;

constexpr int kReadings = 40;

TEST(Steadiness, AGaugeThatDoesNotReturnIsFound) {
  EXPECT_THAT(not_returned({{"call", 0}, {"stream", 1}}, {{"call", 0}, {"stream", 1}}), IsEmpty());
  EXPECT_THAT(not_returned({{"call", 0}, {"stream", 1}}, {{"call", 0}, {"stream", 4}}),
              ElementsAre("stream: 4, was 1"));
}

TEST(Steadiness, ALeakUnderNoiseIsFoundAndWarmingUpIsNot) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-500, 500);
  std::vector<double> steady, leaking;
  for (int i = 0; i < kReadings; ++i) {
    const double warming_up = 50'000.0 * std::min(i, kReadings / 4);
    steady.push_back(1e8 + warming_up + noise(random));
    leaking.push_back(1e8 + warming_up + 300.0 * i + noise(random));
  }
  EXPECT_LT(growth_per_step(steady), 100);
  EXPECT_GT(growth_per_step(leaking), 200);
}

/// Watches a session but never reads.
class IdleWatcher {
 public:
  explicit IdleWatcher(const std::string& address)
      : stub_(v1::Editing::NewStub(wire_channel(address))) {
    v1::WatchRequest request;
    request.mutable_greeting()->set_session("work");
    request.mutable_greeting()->set_pages(true);
    stream_ = stub_->Watch(&context_, request);
  }
  ~IdleWatcher() {
    context_.TryCancel();
    v1::ServerMessage message;
    while (stream_->Read(&message)) continue;
    (void)stream_->Finish();
  }

 private:
  grpc::ClientContext context_;
  std::unique_ptr<v1::Editing::Stub> stub_;
  std::unique_ptr<grpc::ClientReader<v1::ServerMessage>> stream_;
};

class Churn : public testing::Test {
 protected:
  Churn() {
    const CommandOutcome import =
        server_.burnish({"import", write_sphere(server_.folder), "--depth", "4", "--name", "ball"});
    EXPECT_EQ(import.exit_code, 0) << import.output;
    const CommandOutcome open =
        server_.burnish({"open", "ball", "--depth", "4", "--session", "work"});
    EXPECT_EQ(open.exit_code, 0) << open.output;
    metrics_port_ = std::stoi(server_.announced("metrics on port "));
  }

  /// Connects, sends some messages, and leaves without a go_away.
  void come_and_go(int manner) {
    if (manner >= 8) return drop_call(manner);
    LiveStream stream(wire_channel(server_.address), "ann");
    if (manner == 0) return;  // before the greeting
    stream.greet(manner == 1 ? "nothing" : "work");
    if (manner == 1) {
      EXPECT_EQ(stream.end().error_code(), grpc::StatusCode::NOT_FOUND);
      return;
    }
    if (manner == 2) return stream.half_close();
    if (manner == 3) return;  // before the welcome
    stream.next(Case::kWelcome);
    if (manner == 4) return;
    stream.credit(8);
    stream.preview_slide("drag", 0.2);
    if (manner == 5) return;  // before the frames
    stream.next(Case::kFrame);
    stream.slide("known", 0.5);  // a known edit from the second time on: the history does not grow
    if (manner == 6) return;
    EXPECT_TRUE(stream.next(Case::kAcknowledged).has_acknowledged());
    stream.half_close();
    const grpc::Status status = stream.end();
    EXPECT_TRUE(status.ok()) << status.error_message();
  }

  /// Makes a call that ends early, by a cancel or a deadline.
  void drop_call(int manner) {
    WireCall wire;
    if (manner == 8) {
      v1::ImportRequest header, chunk;
      header.mutable_header()->set_name("half");
      header.mutable_header()->set_format(v1::MESH_FORMAT_PLY);
      header.mutable_header()->set_size_bytes(1'000'000);
      chunk.mutable_chunk()->set_data(std::string(100'000, 'x'));
      chunk.mutable_chunk()->set_crc32(chunk_crc32(chunk.chunk().data()));
      wire.method = "/burnish.v1.Library/Import";
      wire.messages = {header.SerializeAsString(), chunk.SerializeAsString()};
      wire.cancel = wire.keep_open = true;
    } else {
      v1::ExportRequest request;
      request.set_session("work");
      request.set_format(v1::MESH_FORMAT_PLY);
      request.set_cycles(5);
      wire.method = "/burnish.v1.Editing/Export";
      wire.messages = {request.SerializeAsString()};
      wire.deadline = std::chrono::milliseconds(5);
    }
    EXPECT_FALSE(call(wire_channel(server_.address), wire).status.ok() && manner == 8);
  }

  std::string metrics() { return http_get_metrics(metrics_port_); }
  double resident() { return metric(metrics(), "burnish_resident_bytes"); }

  /// Waits for these counts: the server notices a dropped stream later than the client.
  LiveCounts counts_once_they_are(const LiveCounts& wanted) {
    LiveCounts counts;
    const auto end = std::chrono::steady_clock::now() + kPatience;
    do {
      counts = live_counts(metrics());
      if (counts == wanted) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    } while (std::chrono::steady_clock::now() < end);
    return counts;
  }

  TemporaryFolder folder_;
  ServerProcess server_{
      {"--metrics", "127.0.0.1:0", "--config",
       folder_.write("server.toml", "[limits]\nconnections_per_peer = 256\n").string()}};
  int metrics_port_ = 0;
};

TEST_F(Churn, LeavesNothingBehind) {
  const int visits = number_from_environment("BURNISH_CHURN", 300);
  const int watcher_count = visits > 300 ? 100 : 10;
  const LiveCounts before = live_counts(metrics());
  ASSERT_EQ(before.at("session"), 1);
  std::vector<double> resident_bytes;
  {
    std::vector<std::unique_ptr<IdleWatcher>> watchers;
    for (int i = 0; i < watcher_count; ++i)
      watchers.push_back(std::make_unique<IdleWatcher>(server_.address));
    std::mt19937 random(1);
    for (int i = 0; i < visits; ++i) {
      come_and_go(static_cast<int>(random() % 10));
      if ((i + 1) % (visits / kReadings) == 0) resident_bytes.push_back(resident());
    }
    EXPECT_GE(live_counts(metrics()).at("stream"), watcher_count);
  }
  EXPECT_THAT(not_returned(before, counts_once_they_are(before)), IsEmpty());
  EXPECT_EQ(server_.staged(), 0u);

  const double growth = growth_per_step(resident_bytes) * kReadings / visits;
  std::cout << visits << " visits past " << watcher_count << " idle watchers: resident "
            << resident_bytes.front() * 1e-6 << " MB at first, "
            << resident_bytes[resident_bytes.size() / 2] * 1e-6 << " MB in the middle, "
            << resident_bytes.back() * 1e-6 << " MB at the end; " << growth
            << " bytes a visit over the second half\n";
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sanitizers keep freed memory
  EXPECT_LT(growth, 1000 + 16e6 / visits);  // a longer run hides what an allocator keeps
#endif
}

}  // namespace
}  // namespace burnish

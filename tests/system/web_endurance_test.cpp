// The web gateway under load, at its end, and after a kill.
// BURNISH_WEB_SOCKETS=N lets N sockets come and go instead of 1000.

#include <algorithm>
#include <csignal>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "tests/server/metrics/http_get.h"
#include "tests/system/environment.h"
#include "tests/system/web_client.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

constexpr uint64_t kMiB = 1 << 20;

uint64_t resident_bytes_of(const ServerProcess& server) {
  std::ifstream status("/proc/" + std::to_string(server.process->pid()) + "/status");
  std::string word;
  uint64_t kib = 0;
  while (status >> word && word != "VmRSS:") {
  }
  status >> kib;
  return kib * 1024;
}

size_t descriptors_of(const ServerProcess& server) {
  const std::filesystem::directory_iterator found("/proc/" + std::to_string(server.process->pid()) +
                                                  "/fd");
  return static_cast<size_t>(std::distance(begin(found), end(found)));
}

/// Waits until a condition of another process holds.
template <typename Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 6000 && !condition(); ++i) std::this_thread::sleep_for(milliseconds(10));
  return condition();
}

std::string client_message(const std::function<void(v1::ClientMessage&)>& fill) {
  v1::ClientMessage message;
  fill(message);
  return message.SerializeAsString();
}

std::string greeting_to(const std::string& session) {
  return client_message([&](v1::ClientMessage& message) {
    message.mutable_greeting()->set_session(session);
    message.mutable_greeting()->set_pages(true);
  });
}

std::string slide(const std::string& id, double beta) {
  return client_message([&](v1::ClientMessage& message) {
    v1::Edit* edit = message.mutable_apply()->add_edits();
    edit->set_id(id);
    edit->mutable_gradient_scale()->set_beta(beta);
  });
}

/// Returns the edits that the next acknowledgement names; nothing at the socket's end.
std::vector<std::string> next_acknowledged(WebClient& client) {
  while (const auto frame = client.read()) {
    v1::ServerMessage message;
    if (frame->is_text || !message.ParseFromString(frame->bytes)) return {};
    if (!message.has_acknowledged()) continue;
    const auto& ids = message.acknowledged().edit_ids();
    return {ids.begin(), ids.end()};
  }
  return {};
}

class WebEndurance : public testing::Test {
 protected:
  /// Makes a session "work" over a generated sphere.
  void open_work(int level, const std::string& depth) {
    const std::string scan = write_sphere(server_.folder, level);
    run({"import", scan, "--depth", depth, "--name", "ball"});
    run({"open", "ball", "--depth", depth, "--session", "work"});
  }

  void run(std::vector<std::string> words) {
    const CommandOutcome outcome = server_.burnish(std::move(words));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  }

  double metric_of(const std::string& name) const {
    return metric(http_get_metrics(std::stoi(server_.announced("metrics on port "))), name);
  }

  ServerProcess server_{{"--web", "127.0.0.1:0", "--metrics", "127.0.0.1:0"}};
};

TEST_F(WebEndurance, SocketsThatComeAndGoLeaveNothing) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer keeps memory that was given back";
#endif
  const int sockets = number_from_environment("BURNISH_WEB_SOCKETS", 1000);
  const auto come_and_go = [&](int times) {
    for (int i = 0; i < times; ++i) {
      WebClient client(web_address(server_));
      ASSERT_TRUE(client.is_open()) << i;
      ASSERT_TRUE(call(client, {kListScansRpc, {""}}).status.ok()) << i;
      if (i % 2 == 0) client.close();
    }
  };
  come_and_go(sockets / 4);  // caches and pools fill
  const size_t descriptors = descriptors_of(server_);
  const uint64_t before = resident_bytes_of(server_);
  come_and_go(sockets);
  EXPECT_TRUE(comes_true([&] { return descriptors_of(server_) <= descriptors; }))
      << descriptors_of(server_) << " descriptors, were " << descriptors;
  EXPECT_LT(resident_bytes_of(server_), before + 8 * kMiB);
  EXPECT_EQ(metric_of("burnish_web_sockets_total"), sockets / 4 + sockets);
  EXPECT_EQ(metric_of("burnish_web_rpcs_total"), sockets / 4 + sockets);
  EXPECT_GT(metric_of("burnish_web_sent_bytes_total"), 20.0 * sockets);
  EXPECT_TRUE(comes_true([&] { return metric_of("burnish_web_connections") == 0; }));
  EXPECT_TRUE(comes_true([&] { return metric_of("burnish_live_objects{kind=\"call\"}") == 0; }));
}

TEST_F(WebEndurance, ReadersThatStallCostLittleMemoryAndHoldUpNobody) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer keeps memory that was given back";
#endif
  open_work(7, "7");  // 164,000 vertices, 9 MB a file
  v1::ExportRequest wanted;
  wanted.set_session("work");
  wanted.set_format(v1::MESH_FORMAT_PLY);
  const std::string request = wanted.SerializeAsString();
  WebClient first(web_address(server_));
  ASSERT_TRUE(call(first, {kExportRpc, {request}}).status.ok());  // the file is made
  const uint64_t before = resident_bytes_of(server_);
  std::vector<std::unique_ptr<WebClient>> stalled;
  for (int i = 0; i < 8; ++i) {
    stalled.push_back(std::make_unique<WebClient>(web_address(server_),
                                                  WebClientOptions{.receive_buffer_bytes = 4096}));
    stalled.back()->send_text(begin_of(kExportRpc));
    stalled.back()->send_message(request);
    stalled.back()->send_text(R"({"end":true})");
    ASSERT_TRUE(stalled.back()->read());  // it runs
  }
  WebClient other(web_address(server_));
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(call(other, {kListScansRpc, {""}}).status.ok());
  const uint64_t bytes = resident_bytes_of(server_) - std::min(before, resident_bytes_of(server_));
  std::cout << "8 stalled readers: " << bytes / kMiB << " MiB\n";
  EXPECT_LT(bytes, 64 * kMiB);
}

TEST_F(WebEndurance, ConnectionsOfBothWaysInCountTogether) {
  server_.kill();
  server_.flags.insert(
      server_.flags.end(),
      {"--config",
       server_.folder.write("server.toml", "[limits]\nconnections_max = 3\n").string()});
  server_.start();
  WebClient one(web_address(server_)), two(web_address(server_));
  const auto channel = wire_channel(server_.address);
  for (WebClient* client : {&one, &two})  // who has called keeps the place
    EXPECT_TRUE(call(*client, {kListScansRpc, {""}}).status.ok());
  EXPECT_TRUE(call(channel, {kListScansRpc, {""}}).status.ok());
  EXPECT_FALSE(WebClient(web_address(server_)).is_open());
  EXPECT_EQ(metric_of("burnish_refusals_total{reason=\"connections\"}"), 1);
}

TEST_F(WebEndurance, ADrainingServerSaysGoodbyeAndEnds) {
  open_work(3, "4");
  WebClient idle(web_address(server_)), editor(web_address(server_));
  ASSERT_TRUE(call(idle, {kListScansRpc, {""}}).status.ok());
  editor.send_text(begin_of(kEditRpc));
  editor.send_message(greeting_to("work"));
  ASSERT_TRUE(editor.read());
  server_.process->signal(SIGTERM);
  EXPECT_FALSE(idle.read());
  EXPECT_EQ(idle.close_code(), 1001);
  bool was_told = false;
  while (const auto frame = editor.read()) {
    v1::ServerMessage message;
    if (!frame->is_text && message.ParseFromString(frame->bytes) && message.has_go_away())
      was_told = true;
  }
  EXPECT_TRUE(was_told);
  EXPECT_EQ(editor.close_code(), 1001);
  EXPECT_EQ(server_.process->wait(kPatience), 0);
}

TEST_F(WebEndurance, AfterAKillTheClientResumesAndNoAcknowledgedEditIsLost) {
  open_work(3, "4");
  constexpr int kRounds = 5, kEditsPerRound = 20;
  server_.listen = server_.address;
  std::vector<std::string> acknowledged;
  int sent = 0;
  for (int round = 0; round < kRounds; ++round) {
    WebClient client(web_address(server_));
    client.send_text(begin_of(kEditRpc));
    client.send_message(greeting_to("work"));
    const size_t enough = acknowledged.size() + kEditsPerRound / 2;
    // Everything without an answer goes out again with its id, as docs/protocol.md says.
    std::vector<std::string> waiting;
    for (int i = 0; i < sent; ++i)
      if (std::ranges::count(acknowledged, "e" + std::to_string(i)) == 0)
        waiting.push_back("e" + std::to_string(i));
    for (int i = 0; i < kEditsPerRound; ++i) waiting.push_back("e" + std::to_string(sent++));
    for (const std::string& id : waiting) client.send_message(slide(id, 0.5));
    while (acknowledged.size() < enough) {
      const auto ids = next_acknowledged(client);
      ASSERT_FALSE(ids.empty());
      acknowledged.insert(acknowledged.end(), ids.begin(), ids.end());
    }
    server_.kill();
    server_.start();
  }
  WebClient client(web_address(server_));
  const WireAnswer history = call(client, {"/burnish.v1.Editing/GetHistory", {"\x0a\x04work"}});
  v1::GetHistoryResponse response;
  ASSERT_TRUE(history.status.ok()) << history.status.error_message();
  ASSERT_TRUE(response.ParseFromString(history.messages.at(0)));
  std::vector<std::string> recorded;
  for (const auto& entry : response.entries()) recorded.push_back(entry.edit_id());
  for (const std::string& id : acknowledged) EXPECT_EQ(std::ranges::count(recorded, id), 1) << id;
}

}  // namespace
}  // namespace burnish

// Strangers send raw bytes to the service. It must refuse them before they cost anything.

#include <cstring>
#include <fstream>
#include <list>
#include <unistd.h>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"
#include "tests/server/metrics/http_get.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr uint64_t kMiB = 1 << 20;
constexpr char kListScans[] = "/burnish.v1.Library/ListScans";

/// Returns the number under `name` in the status of the server's process; proc(5).
uint64_t status_number(const ServerProcess& server, const std::string& name) {
  std::ifstream status("/proc/" + std::to_string(server.process->pid()) + "/status");
  std::string word;
  uint64_t number = 0;
  while (status >> word && word != name) {
  }
  status >> number;
  return number;
}

/// Returns the server's largest resident memory so far.
uint64_t peak_bytes(const ServerProcess& server) {
  return status_number(server, "VmHWM:") * 1024;
}

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Calls with one message that the client packs with gzip.
grpc::Status packed_call(const std::string& address, const std::string& message) {
  grpc::GenericStub stub(wire_channel(address));
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + kPatience);
  context.set_compression_algorithm(GRPC_COMPRESS_GZIP);
  grpc::CompletionQueue queue;
  const grpc::Slice slice(message);
  const auto call = stub.PrepareUnaryCall(&context, "/burnish.v1.Editing/Apply",
                                          grpc::ByteBuffer(&slice, 1), &queue);
  grpc::ByteBuffer answer;
  grpc::Status status;
  call->StartCall();
  call->Finish(&answer, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  queue.Next(&tag, &ok);
  return status;
}

TEST(Edge, APackedMessageIsRefusedAndNotUnpacked) {
  const ServerProcess server;
  ASSERT_TRUE(call(wire_channel(server.address), {kListScans, {""}}).status.ok());
  const uint64_t before = peak_bytes(server);
  const grpc::Status status = packed_call(server.address, std::string(128 * kMiB, '\0'));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNIMPLEMENTED) << status.error_message();
  EXPECT_LT(peak_bytes(server), before + 32 * kMiB);
}

/// A server that knows anna by the token "abc".
class StrangerTest : public testing::Test {
 protected:
  StrangerTest()
      : server_(
            {"--users",
             folder_
                 .write("users.toml",
                        "[[user]]\nname = \"anna\"\nrole = \"owner\"\ntoken_sha256 = "
                        "\"ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad\"\n")
                 .string(),
             "--metrics", "127.0.0.1:0"}) {}

  std::string metrics() const {
    return http_get_metrics(std::stoi(server_.announced("metrics on port ")));
  }

  TemporaryFolder folder_;
  ServerProcess server_;
};

TEST_F(StrangerTest, HisMessagesAreNeitherReadNorParsed) {
  std::string edits;
  for (int i = 0; i < 7'000'000; ++i) edits += std::string("\x12\x00", 2);  // each takes 64 bytes
  const auto channel = wire_channel(server_.address);
  ASSERT_TRUE(call(channel, {kListScans, {""}, "abc"}).status.ok());
  const uint64_t before = peak_bytes(server_);
  const WireAnswer answer = call(channel, {"/burnish.v1.Editing/Apply", {edits}});
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_LT(peak_bytes(server_), before + 32 * kMiB);
}

TEST_F(StrangerTest, AUsersRequestThatTakesTooMuchMemoryIsRefusedWithTheNumbers) {
  std::string edits = std::string("\x0a\x01s", 3);  // session "s"
  for (int i = 0; i < 7'000'000; ++i) edits += std::string("\x12\x00", 2);
  const WireAnswer answer =
      call(wire_channel(server_.address), {"/burnish.v1.Editing/Apply", {edits}, "abc"});
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(answer.status.error_message(), HasSubstr("requests of user anna hold 0 bytes and"));
  EXPECT_THAT(answer.status.error_message(), HasSubstr("the limit is 67108864"));
}

TEST_F(StrangerTest, TheMethodsThatHeMakesUpAreInNoMetric) {
  const auto channel = wire_channel(server_.address);
  for (int i = 0; i < 20; ++i) {
    const std::string method = "/evil." + std::to_string(i) + "/call";
    EXPECT_EQ(call(channel, {method, {""}}).status.error_code(), grpc::StatusCode::UNIMPLEMENTED);
    EXPECT_EQ(call(channel, {method, {""}, "abc"}).status.error_code(),
              grpc::StatusCode::UNIMPLEMENTED);
  }
  EXPECT_EQ(metrics().find("evil"), std::string::npos);
  EXPECT_EQ(metric(metrics(), "burnish_refusals_total{reason=\"unknown_rpc\"}"), 40);
}

TEST_F(StrangerTest, AFloodOfRefusalsIsCountedAndNotWritten) {
  const auto channel = wire_channel(server_.address);
  for (int i = 0; i < 500; ++i) call(channel, {kListScans, {""}});
  ASSERT_TRUE(server_.process->wait_for_output("the log leaves out", kPatience));
  EXPECT_THAT(server_.process->output(), HasSubstr("more lines of refused calls"));
  EXPECT_LT(count(server_.process->output(), "refused /burnish"), 400u);
  EXPECT_EQ(metric(metrics(), "burnish_refusals_total{reason=\"unauthenticated\"}"), 500);
}

TEST_F(StrangerTest, AnAnswerNeverRepeatsALongName) {
  const WireAnswer answer =
      call(wire_channel(server_.address), {"/" + std::string(4000, 'x'), {""}});
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::UNIMPLEMENTED);
  EXPECT_LT(answer.status.error_message().size(), 1100u);
}

TEST(Edge, StreamsOfReflectionTakeFewThreads) {
  const ServerProcess server;
  grpc::GenericStub stub(wire_channel(server.address));
  ASSERT_TRUE(call(wire_channel(server.address), {kListScans, {""}}).status.ok());
  const uint64_t before = status_number(server, "Threads:");
  std::list<grpc::ClientContext> contexts;
  std::vector<std::unique_ptr<grpc::GenericClientAsyncReaderWriter>> streams;
  grpc::CompletionQueue queue;
  for (int i = 0; i < 60; ++i) {
    streams.push_back(
        stub.PrepareCall(&contexts.emplace_back(),
                         "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", &queue));
    streams.back()->StartCall(nullptr);
    void* tag = nullptr;
    bool ok = false;
    queue.Next(&tag, &ok);
  }
  ASSERT_TRUE(call(wire_channel(server.address), {kListScans, {""}}).status.ok());
  EXPECT_LT(status_number(server, "Threads:"), before + 20);
  for (grpc::ClientContext& context : contexts) context.TryCancel();
  for (auto& stream : streams) {
    grpc::Status status;
    void* tag = nullptr;
    bool ok = false;
    stream->Finish(&status, nullptr);
    queue.Next(&tag, &ok);
  }
}

TEST(Edge, ANameForgesNoLineOfTheLog) {
  const ServerProcess server;
  v1::ExportRequest request;
  request.set_session("x\n[2026-01-01 00:00:00.000] [info] user root logged in \x1b[31m");
  request.set_format(v1::MESH_FORMAT_PLY);
  const WireAnswer answer = call(wire_channel(server.address),
                                 {"/burnish.v1.Editing/Export", {request.SerializeAsString()}});
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(server.process->output(), Not(HasSubstr("\n[2026-01-01")));
  EXPECT_THAT(server.process->output(), Not(HasSubstr("\x1b")));
}

/// A TCP connection to the server that sends given bytes.
class RawConnection {
 public:
  explicit RawConnection(const ServerProcess& server, const char* from = "127.0.0.1")
      : fd_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int port = std::stoi(server.address.substr(server.address.rfind(':') + 1));
    const sockaddr_in own = address(from, 0), other = address("127.0.0.1", port);
    const timeval time = {std::chrono::seconds(kPatience).count(), 0};
    setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof(time));
    EXPECT_EQ(bind(fd_, reinterpret_cast<const sockaddr*>(&own), sizeof(own)), 0);
    EXPECT_EQ(connect(fd_, reinterpret_cast<const sockaddr*>(&other), sizeof(other)), 0);
  }
  ~RawConnection() { close(fd_); }
  RawConnection(const RawConnection&) = delete;

  /// Begins HTTP/2; the server answers with its settings.
  void begin_http2() {
    const std::string bytes("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n\0\0\0\4\0\0\0\0\0", 33);
    EXPECT_EQ(write(fd_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }

  /// Reads until the server closes the connection. Returns false if it does not.
  bool is_closed() {
    char bytes[4096];
    for (;;) {
      const ssize_t length = read(fd_, bytes, sizeof(bytes));
      if (length == 0 || (length < 0 && errno == ECONNRESET)) return true;
      if (length < 0) return false;
    }
  }

  /// Returns whether the server answers with its settings.
  bool is_answered() {
    char byte;
    return read(fd_, &byte, 1) == 1;
  }

 private:
  static sockaddr_in address(const char* host, int port) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(port));
    inet_pton(AF_INET, host, &address.sin_addr);
    return address;
  }

  const int fd_;
};

class ConnectionsTest : public testing::Test {
 protected:
  ServerProcess start(const std::string& limits) const {
    return ServerProcess(
        {"--config", folder_.write("server.toml", "[limits]\n" + limits).string()});
  }
  TemporaryFolder folder_;
};

TEST_F(ConnectionsTest, OfOneAddressAreLimitedAndAnotherIsNotKeptOut) {
  const ServerProcess server = start("connections_per_peer = 2");
  RawConnection first(server), second(server);
  for (RawConnection* let_in : {&first, &second}) {
    let_in->begin_http2();
    EXPECT_TRUE(let_in->is_answered());
  }
  EXPECT_TRUE(RawConnection(server).is_closed());
  EXPECT_TRUE(server.process->wait_for_output(
      "127.0.0.1 has 2 connections open, limits.connections_per_peer is 2", kPatience));
  RawConnection other(server, "127.0.0.2");
  other.begin_http2();
  EXPECT_TRUE(other.is_answered());
}

TEST_F(ConnectionsTest, WithoutACallAreClosedAndTheOthersStay) {
  const ServerProcess server = start("silent_connection_seconds = 1");
  const auto channel = wire_channel(server.address);
  EXPECT_TRUE(call(channel, {kListScans, {""}}).status.ok());
  RawConnection silent(server);
  silent.begin_http2();
  EXPECT_TRUE(silent.is_closed());
  EXPECT_TRUE(call(channel, {kListScans, {""}}).status.ok());
  EXPECT_EQ(count(server.process->output(), "closed the connection of ipv4:127.0.0.1:"), 1u);
}

TEST_F(ConnectionsTest, ThatOnlyAskForHealthAreClosed) {
  const ServerProcess server = start("silent_connection_seconds = 1");
  const auto channel = wire_channel(server.address);
  EXPECT_TRUE(call(channel, {"/grpc.health.v1.Health/Check", {""}}).status.ok());
  EXPECT_TRUE(
      server.process->wait_for_output("closed the connection of ipv4:127.0.0.1:", kPatience));
}

TEST_F(ConnectionsTest, ThatTakeEveryPlaceGiveOneToWhoComesWithACall) {
  const ServerProcess server = start("connections_max = 2");
  RawConnection first(server, "127.0.0.2"), second(server, "127.0.0.3");
  for (RawConnection* stranger : {&first, &second}) {
    stranger->begin_http2();
    EXPECT_TRUE(stranger->is_answered());
  }
  const auto user = wire_channel(server.address);
  EXPECT_TRUE(call(user, {kListScans, {""}}).status.ok());
  EXPECT_TRUE(first.is_closed()) << "the oldest";
  RawConnection third(server, "127.0.0.4");
  EXPECT_TRUE(second.is_closed());
  EXPECT_TRUE(call(user, {kListScans, {""}}).status.ok()) << "it has a place";
}

TEST_F(ConnectionsTest, AnUploadThatSendsNothingMoreIsEnded) {
  const ServerProcess server = start("silent_upload_seconds = 1");
  v1::ImportRequest import;
  import.mutable_header()->set_name("test");
  import.mutable_header()->set_format(v1::MESH_FORMAT_PLY);
  import.mutable_header()->set_size_bytes(1000);
  v1::UploadCellFieldsRequest upload;
  upload.mutable_header()->set_session("work");
  upload.mutable_header()->set_edit_id("one");
  upload.mutable_header()->set_cells(1);
  const std::pair<std::string, std::string> calls[] = {
      {"/burnish.v1.Library/Import", import.SerializeAsString()},
      {"/burnish.v1.Editing/UploadCellFields", upload.SerializeAsString()}};
  for (const auto& [method, message] : calls) {
    WireCall silent{method, {message}};
    silent.keep_open = true;
    const WireAnswer answer = call(wire_channel(server.address), silent);
    EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED) << method;
    EXPECT_THAT(answer.status.error_message(), HasSubstr("the client has sent nothing"));
  }
  EXPECT_EQ(server.staged(), 0u);
}

}  // namespace
}  // namespace burnish

#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include "burnish/v1/library.grpc.pb.h"
#include "common/transfer/chunk.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr char kHealth[] = "/grpc.health.v1.Health/Check";
const std::string kNotServing = "\x08\x02";  // field 1, NOT_SERVING

/// An import that waits for its chunks.
struct LongImport {
  LongImport(const std::string& address, uint64_t size_bytes)
      : library(v1::Library::NewStub(wire_channel(address))), stream(library->Import(&context)) {
    v1::ImportRequest request;
    request.mutable_header()->set_name("test");
    request.mutable_header()->set_format(v1::MESH_FORMAT_PLY);
    request.mutable_header()->set_size_bytes(size_bytes);
    request.mutable_header()->set_depth(4);
    stream->Write(request);
    v1::ImportEvent event;
    stream->Read(&event);
  }

  grpc::Status send(const std::string& bytes) {
    v1::ImportRequest request;
    request.mutable_chunk()->set_data(bytes);
    request.mutable_chunk()->set_crc32(chunk_crc32(bytes));
    stream->Write(request);
    stream->WritesDone();
    return finish();
  }

  grpc::Status finish() {
    v1::ImportEvent event;
    while (stream->Read(&event)) {
    }
    return stream->Finish();
  }

  grpc::ClientContext context;
  std::unique_ptr<v1::Library::Stub> library;
  std::unique_ptr<grpc::ClientReaderWriter<v1::ImportRequest, v1::ImportEvent>> stream;
};

std::vector<std::string> drain_seconds(const TemporaryFolder& folder, int seconds) {
  const std::string config = "drain_seconds = " + std::to_string(seconds) + "\n";
  return {"--config", folder.write("server.toml", config).string()};
}

TEST(Drain, LetsRunningCallsEndAndLetsNobodyElseIn) {
  const TemporaryFolder folder;
  ServerProcess server(drain_seconds(folder, 600));
  const auto channel = wire_channel(server.address);
  ASSERT_TRUE(call(channel, {kHealth, {""}}).status.ok());
  const std::string scan = content_of(write_sphere(folder));
  LongImport import(server.address, scan.size());

  server.process->signal(SIGTERM);
  ASSERT_TRUE(server.process->wait_for_output("draining; 1 running calls", kPatience));
  WireAnswer health = call(channel, {kHealth, {""}});
  for (int i = 0; i < 1000 && health.messages != std::vector{kNotServing}; ++i)
    health = call(channel, {kHealth, {""}});
  EXPECT_THAT(health.messages, testing::ElementsAre(kNotServing));
  const grpc::Status refused = call(channel, {"/burnish.v1.Library/ListScans", {""}}).status;
  EXPECT_EQ(refused.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_THAT(refused.error_message(), HasSubstr("the server is draining"));

  const grpc::Status status = import.send(scan);
  EXPECT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(server.process->wait(kPatience), 0) << server.process->output();
  server.start();
  EXPECT_EQ(server.scans(), 1u);
}

TEST(Drain, CancelsWhatDoesNotEndInTime) {
  const TemporaryFolder folder;
  ServerProcess server(drain_seconds(folder, 0));
  LongImport import(server.address, 1000);
  server.process->signal(SIGTERM);
  EXPECT_FALSE(import.finish().ok());
  EXPECT_EQ(server.process->wait(kPatience), 0) << server.process->output();
  EXPECT_EQ(server.staged(), 0u);
}

TEST(Drain, ASecondSignalEndsAtOnce) {
  const TemporaryFolder folder;
  ServerProcess server(drain_seconds(folder, 600));
  LongImport import(server.address, 1000);
  server.process->signal(SIGTERM);
  ASSERT_TRUE(server.process->wait_for_output("draining", kPatience));
  for (int i = 0; i < 1000 && !server.process->wait(std::chrono::milliseconds(20)); ++i)
    server.process->signal(SIGTERM);
  EXPECT_EQ(server.process->wait(kPatience), 128 + SIGTERM);
  EXPECT_FALSE(import.finish().ok());
}

TEST(Drain, AWatcherOfHealthDoesNotHoldItUp) {
  const TemporaryFolder folder;
  ServerProcess server(drain_seconds(folder, 600));
  const auto channel = wire_channel(server.address);
  std::thread watcher([&] { call(channel, {"/grpc.health.v1.Health/Watch", {""}}); });
  ASSERT_TRUE(call(channel, {kHealth, {""}}).status.ok());
  server.process->signal(SIGTERM);
  EXPECT_EQ(server.process->wait(kPatience), 0) << server.process->output();
  watcher.join();
}

}  // namespace
}  // namespace burnish

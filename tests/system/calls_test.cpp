#include <atomic>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.grpc.pb.h"
#include "burnish/v1/library.grpc.pb.h"
#include "client/connection/connection.h"
#include "common/transfer/chunk.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

std::shared_ptr<grpc::Channel> connect(const ServerProcess& server) {
  return grpc::CreateChannel(server.address, grpc::InsecureChannelCredentials());
}

/// An import in progress, message by message.
struct Import {
  explicit Import(const ServerProcess& server)
      : library(v1::Library::NewStub(connect(server))), stream(library->Import(&context)) {}

  void send_header(uint64_t size_bytes) {
    v1::ImportRequest request;
    request.mutable_header()->set_name("test");
    request.mutable_header()->set_format(v1::MESH_FORMAT_PLY);
    request.mutable_header()->set_size_bytes(size_bytes);
    stream->Write(request);
  }

  void send_chunk(uint64_t offset, const std::string& data, uint32_t crc32) {
    v1::ImportRequest request;
    request.mutable_chunk()->set_offset(offset);
    request.mutable_chunk()->set_data(data);
    request.mutable_chunk()->set_crc32(crc32);
    stream->Write(request);
  }

  /// Reads events until `bytes` are stored.
  void wait_until_stored(uint64_t bytes) {
    v1::ImportEvent event;
    while (stream->Read(&event) && event.received().bytes() < bytes) {
    }
  }

  /// Reads the events first: the status comes after them.
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

TEST(Calls, AnUploadThatIsCutOffLeavesNothing) {
  ServerProcess server;
  Import import(server);
  import.send_header(1000);
  import.send_chunk(0, "half", chunk_crc32("half"));
  import.wait_until_stored(4);
  EXPECT_EQ(server.staged(), 1u);
  import.context.TryCancel();
  EXPECT_EQ(import.finish().error_code(), grpc::StatusCode::CANCELLED);
  for (int i = 0; i < 1000 && server.staged() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(server.staged(), 0u);
  EXPECT_EQ(server.scans(), 0u);
}

TEST(Calls, AnUploadThatEndsEarlyIsDataLoss) {
  ServerProcess server;
  Import import(server);
  import.send_header(1000);
  import.send_chunk(0, "half", chunk_crc32("half"));
  import.stream->WritesDone();
  const grpc::Status status = import.finish();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DATA_LOSS);
  EXPECT_EQ(status.error_message(), "the upload ended after 4 of 1000 bytes");
}

TEST(Calls, ADamagedChunkIsDataLoss) {
  ServerProcess server;
  Import import(server);
  import.send_header(1000);
  import.send_chunk(0, "hale", chunk_crc32("half"));
  EXPECT_EQ(import.finish().error_code(), grpc::StatusCode::DATA_LOSS);
}

TEST(Calls, AnImportBeginsWithItsHeader) {
  ServerProcess server;
  Import import(server);
  import.send_chunk(0, "half", chunk_crc32("half"));
  EXPECT_EQ(import.finish().error_code(), grpc::StatusCode::INVALID_ARGUMENT);
}

TEST(Calls, AMessageAboveTheReceiveLimitIsRefused) {
  ServerProcess server;
  Import import(server);
  import.send_header(100 << 20);
  import.send_chunk(0, std::string(17 << 20, 'x'), 0);
  EXPECT_EQ(import.finish().error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(server.burnish({"meshes"}).exit_code, 0);
}

TEST(Calls, AnUploadUnderWayDoesNotHoldUpTheServersEnd) {
  ServerProcess server;
  Import import(server);
  import.send_header(1000);
  import.wait_until_stored(0);
  server.process->signal(SIGTERM);
  EXPECT_EQ(server.process->wait(kPatience), 0) << server.process->output();
  EXPECT_FALSE(import.finish().ok());
}

TEST(Calls, EditsOfManyClientsAtOnceAllCount) {
  constexpr int kClients = 8, kEdits = 20;
  ServerProcess server;
  const std::string scan = write_sphere(server.folder);
  ASSERT_EQ(server.burnish({"import", scan, "--depth", "5", "--name", "ball"}).exit_code, 0);
  ASSERT_EQ(server.burnish({"open", "ball", "--depth", "5", "--session", "work"}).exit_code, 0);
  std::atomic<int> applied{0};
  std::vector<std::thread> clients;
  for (int client = 0; client < kClients; ++client)
    clients.emplace_back([&server, &applied, client] {
      const auto editing = v1::Editing::NewStub(connect(server));
      for (int i = 0; i < kEdits; ++i) {
        grpc::ClientContext context;
        v1::ApplyRequest request;
        request.set_session("work");
        v1::Edit* edit = request.add_edits();
        edit->set_id(std::to_string(client) + "-" + std::to_string(i));
        edit->mutable_gradient_scale()->set_beta(0.01 * i);
        v1::ApplyResponse response;
        if (editing->Apply(&context, request, &response).ok())
          applied += static_cast<int>(response.applied());
      }
    });
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(applied, kClients * kEdits);
  EXPECT_THAT(server.burnish({"sessions", "work"}).output, testing::ContainsRegex("edits +160"));
}

TEST(Calls, AProposalHearsItsCallersCancelAndNamesAnUnknownScan) {
  ServerProcess server;
  auto connection = Connection::open(server.address, kPatience).value();
  ASSERT_TRUE(connection.import_scan(write_sphere(server.folder), "ball", {5, 0}, {}).is_ok());
  const Progress leave = [](std::string_view, double) { return false; };
  EXPECT_EQ(connection.propose_edges("ball", leave).status().code(), StatusCode::kCancelled);
  const auto proposal = connection.propose_edges("ball", {});
  ASSERT_TRUE(proposal.is_ok()) << proposal.status().to_string();
  EXPECT_EQ(*proposal, connection.propose_edges("ball", leave).value());  // nothing to wait for
  const Status unknown = connection.propose_edges("none", {}).status();
  EXPECT_EQ(unknown.code(), StatusCode::kNotFound);
  EXPECT_THAT(unknown.message(), testing::HasSubstr("'none'"));
}

}  // namespace
}  // namespace burnish

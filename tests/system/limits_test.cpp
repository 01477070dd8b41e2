// Limits of a user and of the whole server, over real connections.

#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.grpc.pb.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/server/metrics/http_get.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::HasSubstr;

// The hash of the token "abc".
constexpr char kUsers[] =
    "[[user]]\nname = \"anna\"\nrole = \"owner\"\n"
    "token_sha256 = \"ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad\"\n";

/// A server with one user and limits.
class LimitsTest : public testing::Test {
 protected:
  std::unique_ptr<ServerProcess> start(const std::string& limits) const {
    const std::string config =
        "users = \"" + folder_.write("users.toml", kUsers).string() + "\"\n[limits]\n" + limits;
    auto server = std::make_unique<ServerProcess>(std::vector<std::string>{
        "--config", folder_.write("server.toml", config).string(), "--metrics", "127.0.0.1:0"});
    server->client_flags = {"--token-file", folder_.write("token", "abc").string()};
    return server;
  }

  TemporaryFolder folder_;
};

/// An import that has begun.
struct Upload {
  Upload(const std::shared_ptr<grpc::Channel>& channel, uint64_t size_bytes)
      : library(v1::Library::NewStub(channel)) {
    context.AddMetadata("authorization", "Bearer abc");
    stream = library->Import(&context);
    v1::ImportRequest request;
    request.mutable_header()->set_name("test");
    request.mutable_header()->set_format(v1::MESH_FORMAT_PLY);
    request.mutable_header()->set_size_bytes(size_bytes);
    stream->Write(request);
    v1::ImportEvent event;
    if (!stream->Read(&event)) status = stream->Finish();  // the server has refused it
  }
  ~Upload() { context.TryCancel(); }

  grpc::ClientContext context;
  std::unique_ptr<v1::Library::Stub> library;
  std::unique_ptr<grpc::ClientReaderWriter<v1::ImportRequest, v1::ImportEvent>> stream;
  grpc::Status status;
};

TEST_F(LimitsTest, StreamsOfAUser) {
  const auto server = start("streams_per_user = 2");
  const auto channel = wire_channel(server->address);
  const Upload first(channel, 10);
  {
    const Upload second(channel, 10), third(channel, 10);
    EXPECT_TRUE(second.status.ok());
    EXPECT_EQ(third.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_EQ(third.status.error_message(),
              "user anna has 2 streams and needs 1 more; limits.streams_per_user is 2");
  }
  // An ended upload gives its place back as soon as the server notices.
  for (int i = 0; i < 1000; ++i)
    if (Upload(channel, 10).status.ok()) return;
  FAIL() << "no stream came free";
}

TEST_F(LimitsTest, UploadBytesOfAUser) {
  const auto server = start("upload_bytes_per_user = 1000");
  const auto channel = wire_channel(server->address);
  const Upload first(channel, 700);
  EXPECT_TRUE(first.status.ok());
  const Upload second(channel, 400);
  EXPECT_EQ(second.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(second.status.error_message(),
              HasSubstr("has 700 bytes of uploads under way and needs 400 more; "
                        "limits.upload_bytes_per_user is 1000"));
  EXPECT_TRUE(Upload(channel, 300).status.ok());
}

TEST_F(LimitsTest, SessionsOfAUser) {
  const auto server = start("sessions_per_user = 1");
  ASSERT_EQ(server->burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                .exit_code,
            0);
  const auto open = [&](const char* name) {
    return server->burnish({"open", "ball", "--depth", "4", "--session", name});
  };
  EXPECT_EQ(open("one").exit_code, 0);
  const CommandOutcome refused = open("two");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("user anna has 1 sessions open and needs 1 more; "
                                        "limits.sessions_per_user is 1"));
  EXPECT_EQ(open("one").exit_code, 0);
  EXPECT_EQ(server->burnish({"close", "one"}).exit_code, 0);
  EXPECT_EQ(open("two").exit_code, 0);
}

TEST_F(LimitsTest, ASessionIsAdmittedByItsBytes) {
  const auto server = start("memory_bytes_max = 12000000");
  ASSERT_EQ(server->burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                .exit_code,
            0);
  const auto open = [&](const char* name) {
    return server->burnish({"open", "ball", "--depth", "4", "--session", name});
  };
  const CommandOutcome first = open("one");
  EXPECT_EQ(first.exit_code, 0) << first.output;
  const CommandOutcome refused = open("two");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("bytes of meshes and sessions and needs"));
  EXPECT_THAT(refused.output, HasSubstr("limits.memory_bytes_max is 12000000"));
  EXPECT_EQ(server->burnish({"close", "one"}).exit_code, 0);
  EXPECT_EQ(open("two").exit_code, 0);
}

/// Writes two triangles: a few hundred bytes, but gigabytes of cells at large depths.
std::string write_square(const TemporaryFolder& folder) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0.1}, {0, 1, 0.3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto path = folder / "square.ply";
  EXPECT_TRUE(write_mesh(mesh, path).is_ok());
  return path.string();
}

TEST_F(LimitsTest, ADepthBeyondTheMemoryIsRefusedBeforeAnythingIsTaken) {
  const auto server = start("memory_bytes_max = 536870912");
  const auto resident_bytes = [&] {
    return metric(http_get_metrics(std::stoi(server->announced("metrics on port "))),
                  "burnish_resident_bytes");
  };
  const double before = resident_bytes();
  const CommandOutcome refused =
      server->burnish({"import", write_square(folder_), "--depth", "11", "--name", "square"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("preparing 2 triangles at depth 11 takes"));
  EXPECT_THAT(refused.output, HasSubstr("limits.memory_bytes_max is 536870912"));
  EXPECT_THAT(refused.output, HasSubstr("; depth 9 fits"));
  EXPECT_EQ(server->scans(), 0u);
  EXPECT_EQ(server->staged(), 0u);
  EXPECT_LT(resident_bytes() - before, 1e8);
}

TEST_F(LimitsTest, AServerThatCannotHaveTheMemoryForAPreparationLivesOn) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer takes all addresses for itself";
#endif
  const auto server = start("memory_bytes_max = 100000000000");
  server->kill();
  server->start({.file_bytes_max = {}, .address_bytes_max = uint64_t{2} << 30});
  ASSERT_EQ(server->burnish({"import", write_square(folder_), "--depth", "7", "--name", "square"})
                .exit_code,
            0);
  for (int i = 0; i < 3; ++i) {
    const CommandOutcome refused =
        server->burnish({"open", "square", "--depth", "11", "--session", "deep"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.output, HasSubstr("not enough memory"));
  }
  const CommandOutcome opened =
      server->burnish({"open", "square", "--depth", "7", "--session", "work"});
  EXPECT_EQ(opened.exit_code, 0) << opened.output;
}

TEST_F(LimitsTest, AnUploadOfMoreCellsThanThereAreIsRefusedAtItsHeader) {
  const auto server = start("");
  ASSERT_EQ(server->burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                .exit_code,
            0);
  ASSERT_EQ(server->burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  v1::UploadCellFieldsRequest header;
  header.mutable_header()->set_session("work");
  header.mutable_header()->set_edit_id("cells");
  header.mutable_header()->set_cells(4'000'000);
  const grpc::Status status =
      call(wire_channel(server->address),
           {"/burnish.v1.Editing/UploadCellFields", {header.SerializeAsString()}, "abc"})
          .status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("sets 4000000 cells, session work has "));
}

TEST_F(LimitsTest, ConnectionsBeyondTheLimitAreClosedAndComeBackLater) {
  const auto server = start("connections_max = 2");
  {
    const Upload first(wire_channel(server->address), 10);
    const Upload second(wire_channel(server->address), 10);
    EXPECT_TRUE(first.status.ok() && second.status.ok());
    EXPECT_EQ(server->burnish({"meshes", "--timeout", "20"}).exit_code, 1);
    EXPECT_THAT(server->process->output(), HasSubstr("limits.connections_max is 2"));
  }
  for (int i = 0; i < 100; ++i)
    if (server->burnish({"meshes", "--timeout", "20"}).exit_code == 0) return;
  FAIL() << "no connection came free";
}

TEST_F(LimitsTest, MessagesThatAreTooLargeOrNoneAreRefusedLoggedAndCounted) {
  const auto server = start("");
  const auto channel = wire_channel(server->address);
  const auto refused = [&](const std::string& method, const std::string& message) {
    return call(channel, {method, {message}, "abc"}).status.error_code();
  };
  const auto counted = [&](const std::string& reason) {
    return metric(http_get_metrics(std::stoi(server->announced("metrics on port "))),
                  "burnish_refusals_total{reason=\"" + reason + "\"}");
  };
  const std::string nonsense = "\xff\xff\xff", large(17 << 20, 'x');
  EXPECT_EQ(refused("/burnish.v1.Library/ListScans", nonsense), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(refused("/burnish.v1.Editing/Export", nonsense), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(refused("/burnish.v1.Library/Import", nonsense), grpc::StatusCode::INVALID_ARGUMENT);
  for (int i = 0; i < 1000 && counted("malformed") < 3; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(counted("malformed"), 3);
  EXPECT_THAT(server->process->output(), HasSubstr("the message is not a request of"));

  EXPECT_EQ(refused("/burnish.v1.Editing/Apply", large), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(refused("/burnish.v1.Library/Import", large), grpc::StatusCode::RESOURCE_EXHAUSTED);
  for (int i = 0; i < 1000 && counted("cut_off") < 2; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(counted("cut_off"), 2);
  EXPECT_TRUE(server->process->wait_for_output("above the receive limit", kPatience));
}

}  // namespace
}  // namespace burnish

// Calls through the web gateway: the same answers as over gRPC.

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"
#include "common/transfer/chunk.h"
#include "tests/system/web_client.h"

namespace burnish {
namespace {

using testing::HasSubstr;

void run(ServerProcess& server, std::vector<std::string> words) {
  const CommandOutcome outcome = server.burnish(std::move(words));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
}

void open_work(ServerProcess& server) {
  run(server, {"import", write_sphere(server.folder), "--depth", "4", "--name", "ball"});
  run(server, {"open", "ball", "--depth", "4", "--session", "work", "--user", "ann"});
}

std::string import_header(uint64_t size_bytes) {
  v1::ImportRequest request;
  request.mutable_header()->set_name("test");
  request.mutable_header()->set_format(v1::MESH_FORMAT_PLY);
  request.mutable_header()->set_size_bytes(size_bytes);
  return request.SerializeAsString();
}

std::string import_chunk(const std::string& data) {
  v1::ImportRequest request;
  request.mutable_chunk()->set_data(data);
  request.mutable_chunk()->set_crc32(chunk_crc32(data));
  return request.SerializeAsString();
}

std::string greeting(const std::string& session) {
  v1::ClientMessage message;
  message.mutable_greeting()->set_session(session);
  message.mutable_greeting()->set_pages(true);
  return message.SerializeAsString();
}

/// Returns the bytes of an export's chunks.
std::string file_in(const WireAnswer& answer) {
  std::string file;
  v1::ExportEvent event;
  for (const std::string& message : answer.messages)
    if (event.ParseFromString(message)) file += event.chunk().data();
  return file;
}

/// Returns the messages of an import that must arrive. A newer one may replace the others.
std::vector<std::string> lasting(const WireAnswer& answer) {
  std::vector<std::string> messages;
  v1::ImportEvent event;
  for (const std::string& message : answer.messages) {
    EXPECT_TRUE(event.ParseFromString(message));
    if (!event.has_progress() && event.received().bytes() == 0) messages.push_back(message);
  }
  return messages;
}

void expect_equal_ends(const WireAnswer& through, const WireAnswer& direct, const WireCall& wire) {
  EXPECT_EQ(through.status.error_code(), direct.status.error_code()) << wire.method;
  EXPECT_EQ(through.status.error_message(), direct.status.error_message()) << wire.method;
}

class WebCalls : public testing::Test {
 protected:
  WebClient connect() { return WebClient(web_address(server_)); }

  /// Expects the same status, text and number of messages of both ways.
  void expect_equal(WebClient& client, const WireCall& wire) {
    const WireAnswer direct = call(channel_, wire);
    const WireAnswer through = call(client, wire);
    expect_equal_ends(through, direct, wire);
    EXPECT_EQ(through.messages.size(), direct.messages.size()) << wire.method;
  }

  ServerProcess server_{{"--web", "127.0.0.1:0"}};
  std::shared_ptr<grpc::Channel> channel_ = wire_channel(server_.address);
};

TEST_F(WebCalls, EveryRpcAnswersAsOverGrpc) {
  const auto methods = all_rpcs();
  ASSERT_GE(methods.size(), 28u);
  WebClient client = connect();
  const std::string none = "\x0a\x04none";  // field 1: a session or a scan that is not there
  for (const std::string& method : methods) {
    expect_equal(client, {method, {""}});
    expect_equal(client, {method, {none}});
    expect_equal(client, {method, {"\xff\xff"}});
  }
  EXPECT_TRUE(client.is_open());
}

TEST_F(WebCalls, MessagesAreThoseOfGrpc) {
  open_work(server_);
  WebClient client = connect();
  for (const WireCall& wire : {WireCall{kListScansRpc, {""}},
                               WireCall{"/burnish.v1.Library/DescribeScan",
                                        {"\x0a\x04"
                                         "ball"}},
                               WireCall{"/burnish.v1.Library/DescribePages",
                                        {"\x0a\x04"
                                         "ball"}},
                               WireCall{"/burnish.v1.Editing/GetHistory",
                                        {"\x0a\x04"
                                         "work"}},
                               WireCall{"/grpc.health.v1.Health/Check", {""}}}) {
    const WireAnswer direct = call(channel_, wire);
    const WireAnswer through = call(client, wire);
    ASSERT_TRUE(direct.status.ok()) << wire.method << direct.status.error_message();
    EXPECT_TRUE(through.status.ok()) << wire.method << through.status.error_message();
    EXPECT_EQ(through.messages, direct.messages) << wire.method;
  }
}

TEST_F(WebCalls, AnExportHasTheBytesOfGrpc) {
  open_work(server_);
  v1::ExportRequest wanted;
  wanted.set_session("work");
  wanted.set_format(v1::MESH_FORMAT_PLY);
  const std::string request = wanted.SerializeAsString();
  WebClient client = connect();
  const WireAnswer direct = call(channel_, {"/burnish.v1.Editing/Export", {request}});
  const WireAnswer through = call(client, {"/burnish.v1.Editing/Export", {request}});
  EXPECT_TRUE(through.status.ok()) << through.status.error_message();
  ASSERT_GT(through.messages.size(), 1u);
  EXPECT_EQ(file_in(through), file_in(direct));
  EXPECT_GT(file_in(through).size(), 10'000u);
}

TEST_F(WebCalls, AnUnknownRpcIsRefusedAndTheSocketGoesOn) {
  WebClient client = connect();
  expect_equal(client, {"/burnish.v1.Library/Format", {""}});
  expect_equal(client, {"/nonsense", {""}});
  EXPECT_TRUE(call(client, {kListScansRpc, {""}}).status.ok());
}

TEST_F(WebCalls, AnImportIsDoneAfterTheClientsHalfClose) {
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
      "property float y\nproperty float z\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  WebClient client = connect();
  const WireAnswer answer =
      call(client, {kImportRpc, {import_header(ply.size()), import_chunk(ply)}});
  EXPECT_TRUE(answer.status.ok()) << answer.status.error_message();
  EXPECT_EQ(server_.scans(), 1u);
}

TEST_F(WebCalls, AnUploadThatEndsEarlyIsDataLossAsOverGrpc) {
  WebClient client = connect();
  const WireCall wire = {kImportRpc, {import_header(1000), import_chunk("half")}};
  const WireAnswer direct = call(channel_, wire), through = call(client, wire);
  expect_equal_ends(through, direct, wire);
  EXPECT_EQ(through.status.error_code(), grpc::StatusCode::DATA_LOSS);
  EXPECT_EQ(lasting(through), lasting(direct));
  EXPECT_EQ(lasting(through).size(), 1u);
  EXPECT_EQ(server_.scans(), 0u);
}

TEST_F(WebCalls, ACancelEndsTheCallAndTheSocketGoesOn) {
  WebClient client = connect();
  const WireAnswer answer = call(client, {.method = kImportRpc,
                                          .messages = {import_header(1000), import_chunk("half")},
                                          .cancel = true});
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::CANCELLED);
  for (int i = 0; i < 1000 && server_.staged() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));  // the server's own threads
  EXPECT_EQ(server_.staged(), 0u);
  EXPECT_TRUE(call(client, {kListScansRpc, {""}}).status.ok());
}

TEST_F(WebCalls, TheServersEndOfAStreamThatTheClientHoldsOpenReachesIt) {
  WebClient client = connect();
  const WireAnswer answer =
      call(client, {.method = kEditRpc, .messages = {greeting("nowhere")}, .keep_open = true});
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::NOT_FOUND);
  client.send_message("late");
  client.send_text(R"({"end":true})");
  EXPECT_TRUE(call(client, {kListScansRpc, {""}}).status.ok());
}

TEST_F(WebCalls, ACallThatIsBrokenOffLeavesNothing) {
  {
    WebClient client = connect();
    client.send_text(begin_of(kImportRpc));
    client.send_message(import_header(1000));
    client.send_message(import_chunk("half"));
    ASSERT_TRUE(client.read());
    EXPECT_EQ(server_.staged(), 1u);
    client.break_off();
  }
  for (int i = 0; i < 1000 && server_.staged() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));  // the server's own threads
  EXPECT_EQ(server_.staged(), 0u);
}

TEST_F(WebCalls, AMessageOfTheLimitIsTakenAndOneByteMoreIsRefusedWithTheLimit) {
  constexpr size_t kLimit = size_t{16} << 20;
  WebClient client = connect();
  const grpc::Status status = call(client, {kListScansRpc, {std::string(kLimit, '\xff')}}).status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  const grpc::Status above =
      call(client, {kListScansRpc, {std::string(kLimit + 1, '\xff')}}).status;
  EXPECT_EQ(above.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(above.error_message(), HasSubstr("16777216 bytes"));
  EXPECT_FALSE(client.read());
  EXPECT_EQ(client.close_code(), 1009);
}

TEST_F(WebCalls, FramesThatBreakTheRulesCloseTheSocket) {
  for (const char* text : {"{", R"({"hello":1})", R"({"end":true})"}) {
    WebClient client = connect();
    client.send_text(text);
    EXPECT_FALSE(client.read()) << text;
    EXPECT_EQ(client.close_code(), 1002) << text;
  }
}

TEST_F(WebCalls, ASecondCallEndsTheFirstWithTheReason) {
  open_work(server_);
  WebClient client = connect();
  client.send_text(begin_of(kEditRpc));
  client.send_message(greeting("work"));
  ASSERT_TRUE(client.read());
  client.send_text(begin_of(kListScansRpc));
  const grpc::Status status = read_to_end(client).status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("while another runs"));
  EXPECT_FALSE(client.read());
  EXPECT_EQ(client.close_code(), 1002);
}

TEST_F(WebCalls, TheNameOfAUserWithoutATokenIsThatOfTheCall) {
  open_work(server_);
  v1::OpenSessionRequest session;
  session.set_scan("ball");
  session.set_name("hers");
  session.set_depth(4);
  WebClient client = connect();
  client.send_text(R"({"call":"burnish.v1.Editing/OpenSession","user":"zoe"})");
  client.send_message(session.SerializeAsString());
  EXPECT_TRUE(read_to_end(client).status.ok());
  EXPECT_THAT(server_.burnish({"people", "hers"}).output, HasSubstr("owner  zoe"));
}

}  // namespace
}  // namespace burnish

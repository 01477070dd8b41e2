#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::string;

grpc::ByteBuffer to_buffer(const string& bytes) {
  const grpc::Slice slice(bytes);
  return {&slice, 1};
}

string bytes_of(grpc::ByteBuffer& buffer) {
  grpc::Slice slice;
  return buffer.DumpToSingleSlice(&slice).ok() ? string(slice.begin(), slice.end()) : string();
}

/// Calls a method by its name with raw bytes, as a client in any language may: one request, one
/// answer.
string answer_to(const string& address, const string& method, const string& request) {
  const auto channel = grpc::CreateChannel(address, grpc::InsecureChannelCredentials());
  grpc::GenericStub stub(channel);
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + kPatience);
  grpc::CompletionQueue queue;
  const auto stream = stub.PrepareCall(&context, method, &queue);
  const auto wait = [&queue] {
    void* tag = nullptr;
    bool ok = false;
    return queue.Next(&tag, &ok) && ok;
  };
  stream->StartCall(nullptr);
  if (!wait()) return "no call";
  stream->Write(to_buffer(request), nullptr);
  if (!wait()) return "no write";
  grpc::ByteBuffer answer;
  stream->Read(&answer, nullptr);
  const string bytes = wait() ? bytes_of(answer) : "no answer";
  context.TryCancel();
  grpc::Status status;
  stream->Finish(&status, nullptr);
  wait();
  return bytes;
}

TEST(Health, TheServerAndBothServicesServe) {
  const ServerProcess server;
  const string method = "/grpc.health.v1.Health/Check";
  const string serving = "\x08\x01";  // field 1, SERVING
  EXPECT_EQ(answer_to(server.address, method, ""), serving);
  EXPECT_EQ(answer_to(server.address, method,
                      "\x0a\x12"
                      "burnish.v1.Library"),
            serving);
  EXPECT_EQ(answer_to(server.address, method,
                      "\x0a\x12"
                      "burnish.v1.Editing"),
            serving);
}

TEST(Reflection, NamesTheServices) {
  const ServerProcess server;
  const string list_services("\x3a\x00", 2);  // field 7, empty
  const string answer =
      answer_to(server.address, "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo",
                list_services);
  EXPECT_THAT(answer, testing::HasSubstr("burnish.v1.Library"));
  EXPECT_THAT(answer, testing::HasSubstr("burnish.v1.Editing"));
}

}  // namespace
}  // namespace burnish

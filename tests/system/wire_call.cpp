#include "tests/system/wire_call.h"

#include <grpcpp/generic/generic_stub.h>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"

namespace burnish {
namespace {

/// Waits for the one operation in progress. Returns whether it succeeded.
bool wait(grpc::CompletionQueue& queue) {
  void* tag = nullptr;
  bool ok = false;
  return queue.Next(&tag, &ok) && ok;
}

std::string to_bytes(grpc::ByteBuffer& buffer) {
  grpc::Slice slice;
  return buffer.DumpToSingleSlice(&slice).ok() ? std::string(slice.begin(), slice.end()) : "";
}

}  // namespace

std::shared_ptr<grpc::Channel> wire_channel(const std::string& address, const WireTrust& trust) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);  // its own connection
  return grpc::CreateCustomChannel(
      address,
      trust.ca.empty() ? grpc::InsecureChannelCredentials()
                       : grpc::SslCredentials({trust.ca, trust.key, trust.certificate}),
      arguments);
}

WireAnswer call(const std::shared_ptr<grpc::Channel>& channel, const WireCall& wire) {
  grpc::GenericStub stub(channel);
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + wire.deadline);
  if (!wire.token.empty()) context.AddMetadata("authorization", "Bearer " + wire.token);
  grpc::CompletionQueue queue;
  const auto stream = stub.PrepareCall(&context, wire.method, &queue);
  WireAnswer answer;
  stream->StartCall(nullptr);
  bool open = wait(queue);
  for (const std::string& message : wire.messages) {
    const grpc::Slice slice(message);
    if (!open) break;
    stream->Write(grpc::ByteBuffer(&slice, 1), nullptr);
    open = wait(queue);
  }
  if (wire.cancel) context.TryCancel();
  if (open && !wire.keep_open) {
    stream->WritesDone(nullptr);
    wait(queue);
  }
  for (;;) {
    grpc::ByteBuffer message;
    stream->Read(&message, nullptr);
    if (!wait(queue)) break;
    answer.messages.push_back(to_bytes(message));
    if (answer.messages.size() == wire.enough_messages) context.TryCancel();
  }
  stream->Finish(&answer.status, nullptr);
  wait(queue);
  const bool had_enough =
      wire.enough_messages > 0 && answer.messages.size() >= wire.enough_messages;
  if (had_enough && answer.status.error_code() == grpc::StatusCode::CANCELLED)
    answer.status = grpc::Status::OK;
  return answer;
}

std::vector<std::string> all_rpcs() {
  std::vector<std::string> methods;
  for (const auto* file :
       {v1::ListScansRequest::descriptor()->file(), v1::ApplyRequest::descriptor()->file()})
    for (int s = 0; s < file->service_count(); ++s)
      for (int m = 0; m < file->service(s)->method_count(); ++m)
        methods.push_back("/" + file->service(s)->full_name() + "/" +
                          file->service(s)->method(m)->name());
  return methods;
}

}  // namespace burnish

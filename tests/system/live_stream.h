#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.grpc.pb.h"

namespace burnish {

/// A simple client of Editing.Edit: sends and receives messages.
class LiveStream {
 public:
  LiveStream(const std::shared_ptr<grpc::Channel>& channel, const std::string& user = {});
  ~LiveStream();

  bool send(const v1::ClientMessage& message) { return stream_->Write(message); }
  /// Greets, and shows the first page of the scan.
  void greet(const std::string& session);
  void credit(uint32_t frames, const std::vector<uint64_t>& decoded = {});
  void slide(const std::string& id, double beta);
  void preview_slide(const std::string& id, double beta);
  void beat(uint64_t time_us);

  /// Returns the next message that `is_wanted` accepts; keeps the messages before it in `seen`.
  /// Returns a message without a case at the end of the stream.
  v1::ServerMessage next(const std::function<bool(const v1::ServerMessage&)>& is_wanted);
  v1::ServerMessage next(v1::ServerMessage::MessageCase wanted);

  /// Waits for the settled frame. Grants a credit for each frame and acknowledges it.
  v1::Frame settle();

  void half_close() { stream_->WritesDone(); }
  void cancel() { context_.TryCancel(); }

  /// Reads the remaining messages.
  grpc::Status end();

  std::vector<v1::ServerMessage> seen;

 private:
  grpc::ClientContext context_;
  std::unique_ptr<v1::Editing::Stub> stub_;
  std::unique_ptr<grpc::ClientReaderWriter<v1::ClientMessage, v1::ServerMessage>> stream_;
  bool ended_ = false;
};

/// Returns the sequence number in a frame's header.
uint64_t sequence_of(const v1::Frame& frame);

}  // namespace burnish

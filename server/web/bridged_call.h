#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>

#include "server/web/web_gateway.h"

namespace burnish {

/// A call of any kind that the gateway makes for a client, message for message. Each direction has
/// one message in flight. All functions and events run on one strand: `Events::post` brings gRPC's
/// reactions to it.
class BridgedCall : public grpc::ClientBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>,
                    public std::enable_shared_from_this<BridgedCall> {
 public:
  struct Events {
    std::function<void(std::function<void()>)> post;
    std::function<void(grpc::ByteBuffer)> on_message;  ///< read_next() asks for the next one
    std::function<void()> on_sent;                     ///< send() is free again
    std::function<void(const grpc::Status&)> on_end;   ///< the last event
  };
  struct Caller {
    std::string authorization;        ///< empty for none
    std::optional<std::string> user;  ///< burnish-user-bin
    std::string peer;
    std::string certificate;  ///< a common name; empty for none
  };

  BridgedCall(const WebCalls& calls, const std::string& method, const Caller& caller,
              Events events);

  /// Starts the call, which then holds itself until on_end. Asks for the first message.
  void start();

  /// Returns false if the call takes no more messages; then there is no on_sent. Needs: no message
  /// is in flight.
  bool send(const grpc::ByteBuffer& bytes);
  void end_messages();
  void read_next();

  /// The call ends soon, also if nobody reads its messages.
  void cancel();

 private:
  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnDone(const grpc::Status& status) override;

  void read_done(bool ok);
  void let_go();

  const WebCalls& calls_;
  const std::string method_;
  Events events_;
  grpc::ClientContext context_;
  grpc::GenericStub stub_;
  grpc::ByteBuffer in_, out_;
  std::shared_ptr<BridgedCall> self_;
  bool is_reading_ = false;
  bool is_cancelled_ = false;
  bool is_held_ = true;  // gRPC waits with the end while further operations may start
};

}  // namespace burnish

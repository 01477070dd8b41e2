#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.grpc.pb.h"
#include "burnish/v1/library.grpc.pb.h"
#include "client/connection/connection.h"

namespace burnish {

struct Connection::State {
  std::string server;
  ConnectionTrust trust;
  std::string user;
  Connection::Starter starter;  ///< may be empty
  std::chrono::milliseconds timeout;
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<v1::Library::Stub> library;
  std::unique_ptr<v1::Editing::Stub> editing;

  /// For calls that depend on who calls.
  void set_user(grpc::ClientContext& context) const {
    if (!user.empty()) context.AddMetadata("burnish-user-bin", user);
  }

  /// For calls that answer at once.
  void set_deadline(grpc::ClientContext& context) const {
    context.set_deadline(std::chrono::system_clock::now() + timeout);
  }
};

/// Returns what a call ended with, in our words: "server HOST:PORT: ...". The server's own texts
/// stay as they are.
Status call_status(const std::string& server, const grpc::Status& status);

/// Returns in our words why gRPC could not connect. `text`: what it says. A text that is not known
/// stays as it is.
std::string no_link_words(std::string_view text);

}  // namespace burnish

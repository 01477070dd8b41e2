#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <grpcpp/grpcpp.h>

namespace burnish {

/// How a test connects; PEM text.
struct WireTrust {
  std::string ca;  ///< empty: plain text
  std::string certificate, key;
};

std::shared_ptr<grpc::Channel> wire_channel(const std::string& address,
                                            const WireTrust& trust = {});

/// Calls any RPC with raw bytes, as a client in any language may: sends the messages, then reads to
/// the end.
struct WireCall {
  std::string method;
  std::vector<std::string> messages;
  std::string token = {};
  std::chrono::milliseconds deadline{120'000};
  bool cancel = false;         ///< cancels once the messages are sent
  bool keep_open = false;      ///< does not close the client's side
  size_t enough_messages = 0;  ///< messages of an endless call; then it is cancelled, as OK
};
struct WireAnswer {
  grpc::Status status;
  std::vector<std::string> messages;
};
WireAnswer call(const std::shared_ptr<grpc::Channel>& channel, const WireCall& wire);

/// Returns "/burnish.v1.Library/ListScans" and all other RPCs of the services.
std::vector<std::string> all_rpcs();

}  // namespace burnish

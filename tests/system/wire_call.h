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

/// A call of any RPC, made of bytes as any client in any language may make it: sends the messages,
/// reads to the end.
struct WireCall {
  std::string method;
  std::vector<std::string> messages;
  std::string token = {};
  std::chrono::milliseconds deadline{120'000};
  bool cancel = false;     ///< once the messages are sent
  bool keep_open = false;  ///< do not say that there are no more
  size_t enough_messages =
      0;  ///< of an endless call, so many; then it is cancelled and counts as OK
};
struct WireAnswer {
  grpc::Status status;
  std::vector<std::string> messages;
};
WireAnswer call(const std::shared_ptr<grpc::Channel>& channel, const WireCall& wire);

/// "/burnish.v1.Library/ListScans" and all the others of our services.
std::vector<std::string> all_rpcs();

}  // namespace burnish

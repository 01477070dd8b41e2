#pragma once

#include <memory>

#include <grpcpp/grpcpp.h>

#include "client/connection/connection.h"

namespace burnish {

enum class Sharing {
  kShared,  ///< channels to the same server are one TCP connection
  kOwn,     ///< nothing else travels on this one
};

/// Returns true when the channel is ready; false when an attempt failed or the time is over.
bool wait_until_ready(grpc::Channel& channel, std::chrono::milliseconds timeout);

/// Tries to connect at once, and waits until the channel is ready or the time is over.
void connect_again(grpc::Channel& channel, std::chrono::milliseconds timeout);

/// Returns the target that gRPC knows a server by: the path of unix:PATH percent-encoded, all else
/// as it is.
std::string grpc_target(const std::string& server);

/// A channel that has not connected yet; every call on it carries the token.
/// Fails: as errno says (files), failed_precondition (a token in plain text), invalid_argument.
Result<std::shared_ptr<grpc::Channel>> make_channel(const std::string& server,
                                                    const ConnectionTrust& trust,
                                                    Sharing sharing = Sharing::kShared);

}  // namespace burnish

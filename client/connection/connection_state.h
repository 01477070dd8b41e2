#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.grpc.pb.h"
#include "burnish/v1/library.grpc.pb.h"
#include "client/connection/connection.h"
#include "client/live/server_route.h"

namespace burnish {

/// Returns what a call ended with, in our words: "server HOST:PORT: ...". The server's own texts
/// stay as they are. Says where a session has moved to.
Status call_status(const std::string& server, const grpc::Status& status);

/// Has a proxy lead a call to the server of this name, if the name is known.
void set_node(grpc::ClientContext& context, const std::string& node);

/// How long a call waits for another server to take a session over: a fleet's usual lease, and what
/// the takeover takes.
inline constexpr std::chrono::seconds kTakeoverMax{13};

/// A server of sessions, and the way there.
struct ReachedServer {
  ServerPlace place;
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<v1::Editing::Stub> editing;
  std::unique_ptr<v1::Library::Stub> library;
};

struct Connection::State {
  std::string server;  ///< that open() has connected to, which has the library
  ConnectionTrust trust;
  std::string user;
  Connection::Starter starter;  ///< may be empty
  std::chrono::milliseconds timeout;
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<v1::Library::Stub> library;
  std::unique_ptr<v1::Editing::Stub> editing;
  std::shared_ptr<ServerRoute> route;  ///< to the server of the sessions

  std::mutex mutex;                              // of what follows
  std::shared_ptr<const ReachedServer> reached;  // where a session was found last; null: `server`

  /// Returns the server to which the route leads. Fails: as make_channel().
  Result<std::shared_ptr<const ReachedServer>> reach();

  /// Waits a moment, and turns back to the first server, if the call has never left because nothing
  /// listens where the session was. Returns false if there is nothing to wait for, or not longer.
  bool awaits_takeover(const ReachedServer& owner, const grpc::Status& ended,
                       std::chrono::steady_clock::time_point until);

  /// Makes a call about a session where the session is: follows it up to kMovesMax times, and waits
  /// up to kTakeoverMax for a server to take it over. Shape of a call:
  /// grpc::Status(v1::Editing::Stub&, grpc::ClientContext&); it may be made again until the server
  /// has taken it. Fails: as the last server says.
  template <typename Call>
  Status call_owner(const Call& call) {
    return call_reached([&](const ReachedServer& owner, grpc::ClientContext& context) {
      return call(*owner.editing, context);
    });
  }

  /// Does the same for a call of any service: grpc::Status(const ReachedServer&,
  /// grpc::ClientContext&).
  template <typename Call>
  Status call_reached(const Call& call) {
    const auto until = std::chrono::steady_clock::now() + kTakeoverMax;
    for (int moves = 0;; ++moves) {
      ASSIGN_OR_RETURN(const auto owner, reach());
      grpc::ClientContext context;
      set_user(context);
      set_node(context, owner->place.node);
      const grpc::Status ended = call(*owner, context);
      if (awaits_takeover(*owner, ended, until)) {
        moves = -1;  // before the next round
        continue;
      }
      const Status status = call_status(owner->place.address, ended);
      if (status.moved_to().empty() || moves == kMovesMax) return status;
      route->move_to(ServerPlace::of(status.moved_to()));
    }
  }

  /// For calls that depend on who calls.
  void set_user(grpc::ClientContext& context) const {
    if (!user.empty()) context.AddMetadata("burnish-user-bin", user);
  }

  /// For calls that answer at once.
  void set_deadline(grpc::ClientContext& context) const {
    context.set_deadline(std::chrono::system_clock::now() + timeout);
  }
};

/// Returns in our words why gRPC could not connect. `text`: what it says. A text that is not known
/// stays as it is.
std::string no_link_words(std::string_view text);

}  // namespace burnish

#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.pb.h"
#include "server/live/live_sessions.h"

namespace burnish {

/// Sends messages to one client of a live session, a write at a time, and ends the call after the
/// last. Thread-safe.
class LiveWriter {
 public:
  LiveWriter(std::function<void(const v1::ServerMessage*)> start_write,
             std::function<void(grpc::Status)> finish)
      : start_write_(std::move(start_write)), finish_(std::move(finish)) {}

  /// Reports progress while the client waits for its place. Only the newest is sent.
  void report_progress(std::string_view phase, double fraction);

  /// Welcomes the client; its subscriber's messages follow.
  void begin(const LiveClient& client);

  /// Ends the call without the remaining messages. The first end counts.
  void end(const Status& status);

  /// Call when there may be something to send.
  void pump();

  void on_write_done(bool ok);

  /// Returns the message of the finished write. Needs: called from OnWriteDone, before
  /// on_write_done().
  const v1::ServerMessage& written() const { return current_; }

  /// Runs `start`, which starts another operation of the call, unless the call has ended.
  void unless_finished(const std::function<void()>& start);

 private:
  // Reactions never run inside StartWrite or Finish, so the lock may be held here.
  void advance();
  bool take_next();

  const std::function<void(const v1::ServerMessage*)> start_write_;
  const std::function<void(grpc::Status)> finish_;
  std::mutex mutex_;  // guards the following members
  std::shared_ptr<Subscriber> subscriber_;
  std::optional<ServerMessage> first_;  // progress, then the welcome
  std::optional<grpc::Status> end_;
  v1::ServerMessage current_;
  bool writing_ = false;
  bool finished_ = false;
};

}  // namespace burnish

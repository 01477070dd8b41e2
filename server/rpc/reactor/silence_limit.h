#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include <grpcpp/alarm.h>

#include "common/base/status.h"

namespace burnish {

/// Notices a client that should send and has been silent for too long. A member of its call.
/// Thread-safe.
class SilenceLimit {
 public:
  explicit SilenceLimit(std::chrono::milliseconds limit) : limit_(limit) {}

  /// `on_silent` gets deadline_exceeded, at most once and only between wait() and heard(). `owner`:
  /// the call; after its end nothing happens.
  void start(std::weak_ptr<void> owner, std::function<void(const Status&)> on_silent);

  /// Starts to wait for the client.
  void wait();

  /// Notes a message. Returns false if on_silent was called already; the call ends then.
  bool heard();

  /// Stops calling on_silent; a call that is under way continues.
  void stop();

 private:
  void set_alarm(std::chrono::milliseconds time);  // needs the lock
  void ring();

  const std::chrono::milliseconds limit_;
  std::mutex mutex_;  // guards the following members
  std::weak_ptr<void> owner_;
  std::function<void(const Status&)> on_silent_;
  std::unique_ptr<grpc::Alarm> alarm_;
  std::optional<std::chrono::steady_clock::time_point> waiting_since_;
  bool is_silent_ = false;
  bool stopped_ = false;
};

}  // namespace burnish

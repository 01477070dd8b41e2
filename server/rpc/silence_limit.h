#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include <grpcpp/alarm.h>

#include "common/base/status.h"

namespace burnish {

/// Notices that a client that is waited for has sent nothing for too long. A member of its call.
/// Thread-safe.
class SilenceLimit {
 public:
  explicit SilenceLimit(std::chrono::milliseconds limit) : limit_(limit) {}

  /// `on_silent` hears deadline_exceeded, once at most and only while the client is waited for.
  /// `owner`: the call; nothing happens once it is gone.
  void start(std::weak_ptr<void> owner, std::function<void(const Status&)> on_silent);

  /// The client is waited for from now on.
  void wait();

  /// Something has come. False: on_silent has been called already, and that is the call's end.
  bool heard();

  /// on_silent is not called from now on, but for a call that is under way.
  void stop();

 private:
  void set_alarm(std::chrono::milliseconds time);  // needs the lock
  void ring();

  const std::chrono::milliseconds limit_;
  std::mutex mutex_;  // of what follows
  std::weak_ptr<void> owner_;
  std::function<void(const Status&)> on_silent_;
  std::unique_ptr<grpc::Alarm> alarm_;
  std::optional<std::chrono::steady_clock::time_point> waiting_since_;
  bool is_silent_ = false;
  bool stopped_ = false;
};

}  // namespace burnish

#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.grpc.pb.h"
#include "common/service/live.h"

namespace burnish {

/// Wakes the one thread that waits for several things at once.
class Wakeup {
 public:
  void wake() {
    const std::lock_guard lock(mutex_);
    woken_ = true;
    changed_.notify_one();
  }
  /// Returns when somebody has called wake() since the last wait, or after `time`.
  void wait_for(std::chrono::steady_clock::duration time) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, time, [this] { return woken_; });
    woken_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool woken_ = false;
};

/// The headers of a call.
struct LiveHeaders {
  std::string user;  ///< empty: none
  std::string node;  ///< the name of the server that is meant; empty: any
};

/// One Editing.Edit call. One message is written at a time, and one read: the next is asked for
/// when the last has been taken, so that whoever is slow holds up the server and not this memory.
class LiveStream final : public grpc::ClientBidiReactor<v1::ClientMessage, v1::ServerMessage> {
 public:
  /// `wakeup` is woken whenever one of the questions below has another answer.
  static std::shared_ptr<LiveStream> start(std::shared_ptr<grpc::Channel> channel,
                                           const LiveHeaders& headers,
                                           std::shared_ptr<Wakeup> wakeup);

  bool can_write() const;
  /// Needs: can_write().
  void write(const ClientMessage& message);
  std::optional<v1::ServerMessage> take_message();
  /// How the call ended, once it has.
  std::optional<grpc::Status> status() const;
  void cancel();

  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnDone(const grpc::Status& status) override;

 private:
  LiveStream(std::shared_ptr<grpc::Channel> channel, std::shared_ptr<Wakeup> wakeup);
  void close();

  const std::shared_ptr<grpc::Channel> channel_;
  const std::unique_ptr<v1::Editing::Stub> stub_;
  const std::shared_ptr<Wakeup> wakeup_;
  grpc::ClientContext context_;
  std::shared_ptr<LiveStream> self_;  // until OnDone

  mutable std::mutex mutex_;
  v1::ClientMessage outgoing_;
  v1::ServerMessage incoming_;
  bool writing_ = false;
  bool has_message_ = false;
  bool cancelled_ = false;
  bool closed_ = false;  // no more operations
  std::optional<grpc::Status> status_;
};

}  // namespace burnish

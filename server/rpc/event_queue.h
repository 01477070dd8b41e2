#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include <grpcpp/grpcpp.h>

namespace burnish {

/// What a streaming call has to say to its client, one write at a time. Of progress only the newest
/// is kept, so that a slow client costs nothing and holds up nobody. Thread-safe.
template <typename Event>
class EventQueue {
 public:
  EventQueue(std::function<void(const Event*)> start_write,
             std::function<void(grpc::Status)> finish)
      : start_write_(std::move(start_write)), finish_(std::move(finish)) {}

  /// An event that a newer one may replace.
  void offer(Event event) {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    newest_ = std::move(event);
    advance();
  }

  /// An event that must arrive, in order.
  void push(Event event) {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    newest_.reset();
    events_.push_back(std::move(event));
    advance();
  }

  /// Ends the call when everything pushed has been written. The first close counts.
  void close(grpc::Status status) {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    closed_ = std::move(status);
    advance();
  }

  /// To be called by OnWriteDone. After a failed write the rest is dropped; ending the call stays
  /// with its owner, who alone knows whether a read or work is still under way.
  void on_write_done(bool ok) {
    const std::lock_guard lock(mutex_);
    writing_ = false;
    if (!ok) broken_ = true;
    advance();
  }

  /// The event of the write that is done. Needs: called from OnWriteDone, before on_write_done().
  const Event& written() const { return current_; }

 private:
  // Reactions never run inside StartWrite or Finish, so that the lock may be held here.
  void advance() {
    if (writing_ || finished_) return;
    if (broken_) {
      events_.clear();
      newest_.reset();
    }
    if (!events_.empty()) {
      current_ = std::move(events_.front());
      events_.pop_front();
    } else if (closed_) {
      finished_ = true;
      finish_(*closed_);
      return;
    } else if (newest_) {
      current_ = std::move(*newest_);
      newest_.reset();
    } else {
      return;
    }
    writing_ = true;
    start_write_(&current_);
  }

  const std::function<void(const Event*)> start_write_;
  const std::function<void(grpc::Status)> finish_;
  std::mutex mutex_;
  std::deque<Event> events_;
  std::optional<Event> newest_;
  std::optional<grpc::Status> closed_;
  Event current_;
  bool writing_ = false;
  bool broken_ = false;
  bool finished_ = false;
};

}  // namespace burnish

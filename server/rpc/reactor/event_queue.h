#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <grpcpp/grpcpp.h>

namespace burnish {

/// The messages of a streaming call to its client, one write at a time. Keeps only the newest
/// progress, so a slow client costs nothing and holds up nobody. Thread-safe.
template <typename Event>
class EventQueue {
 public:
  EventQueue(std::function<void(const Event*)> start_write,
             std::function<void(grpc::Status)> finish)
      : start_write_(std::move(start_write)), finish_(std::move(finish)) {}

  /// Adds an event that a newer one may replace.
  void offer(Event event) {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    newest_ = std::move(event);
    advance();
  }

  /// Offers an event that says how far the work is.
  void report(std::string_view phase, double fraction) {
    Event event;
    event.mutable_progress()->set_phase(std::string(phase));
    event.mutable_progress()->set_fraction(fraction);
    offer(std::move(event));
  }

  /// Adds an event that must arrive, in order.
  void push(Event event) {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    newest_.reset();
    events_.push_back(std::move(event));
    advance();
  }

  /// Ends the call after all pushed events are written. The first close counts.
  void close(grpc::Status status) {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    closed_ = std::move(status);
    advance();
  }

  /// Call in OnWriteDone. After a failed write it drops the rest. The owner ends the call: only the
  /// owner knows whether a read or work is still under way.
  void on_write_done(bool ok) {
    const std::lock_guard lock(mutex_);
    writing_ = false;
    if (!ok) broken_ = true;
    advance();
  }

  /// Returns the event of the finished write. Needs: called from OnWriteDone, before
  /// on_write_done().
  const Event& written() const { return current_; }

 private:
  // Reactions never run inside StartWrite or Finish, so the lock may be held here.
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

#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// How a call ended. The code is that of gRPC.
struct CallEnd {
  int code = 0;
  std::string message;
  std::string details;  ///< gRPC's: bytes
};

/// A call of the server, of any kind, as the worker carries it (docs/web.md). Its messages are
/// bytes. Either its owner is told of each event, or work on a stack of its own waits for them.
class HostCall {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `method`: "burnish.v1.Editing/Edit". `node`: the server of a fleet to which a proxy leads the
  /// call; empty: any. `on_event`: another message or the end is there; may be empty.
  explicit HostCall(std::string_view method, std::string_view node = {},
                    std::function<void()> on_event = {});
  /// Cancels the call if it has not ended.
  ~HostCall();
  HostCall(const HostCall&) = delete;
  HostCall& operator=(const HostCall&) = delete;

  /// The call ends with 4, DEADLINE_EXCEEDED, at this time.
  void set_deadline(Time deadline) { deadline_ = deadline; }

  void send(std::string_view message);
  /// Says that no message follows.
  void end_sending();
  void cancel();
  /// Returns the bytes that are not on the link yet.
  size_t buffered() const;

  /// Returns the next message; nothing if it is not there yet, or there is none.
  std::optional<std::vector<uint8_t>> take();
  /// Returns the end, once all messages are taken.
  const std::optional<CallEnd>& end() const { return heard_.empty() ? end_ : no_end_; }

  // For work on a stack of its own.

  /// Waits for the next message. Returns nothing at the end.
  std::optional<std::vector<uint8_t>> wait_for_message();
  /// Waits until the call has ended; messages before that are dropped.
  CallEnd wait_for_end();
  /// Waits until at most this much is not on the link. Returns false if the call has ended.
  bool wait_for_room(size_t bytes);

  // For core_call_message(), core_call_ended() and core_tick().
  static void on_message(int call, std::vector<uint8_t> message);
  static void on_end(int call, CallEnd end);
  /// Ends calls whose deadline is over, and wakes those that wait for room. Returns when to look
  /// again.
  static Time look_at_all(Time now);

 private:
  void tell();
  void wait();

  int number_;
  std::function<void()> on_event_;
  std::optional<Time> deadline_;
  std::deque<std::vector<uint8_t>> heard_;
  std::optional<CallEnd> end_;
  const std::optional<CallEnd> no_end_;
  int waiting_ = 0;  // the stack that waits; 0: none
  bool waits_for_room_ = false;
};

}  // namespace burnish

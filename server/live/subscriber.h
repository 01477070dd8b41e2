#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "common/frame_codec/frame_encoder.h"
#include "common/service/live.h"
#include "server/live/frame_target.h"
#include "server/manager/caller.h"
#include "server/metrics/live_objects.h"
#include "server/scheduling/executor.h"

namespace burnish {

/// The surface at one moment, as the frames of one target see it.
struct Shot {
  std::shared_ptr<const FrameSample> sample;
  uint64_t version = 0;  ///< of the surface: grows with every cycle
  FrameStats stats;
};

/// How a subscriber reaches others. Called from any thread, without locks of ours held.
struct SubscriberWiring {
  std::function<void()> on_message;  ///< there may be something to take()
  std::function<void()> on_dead;     ///< nothing more can be told: the connection is to be cut
  std::function<void()> on_wish;     ///< wants_frame() may have become true
  bool may_be_silent = false;        ///< the client cannot say that it is there
  /// Whether the client would be let in again; empty: it would. Asked from time to time.
  std::function<Status()> may_stay;
};

/// One client of a live session, as the server sees it: its credits and its encoder, and what there
/// is to tell it. Of what a newer message replaces only the newest is kept, and a frame is made
/// only when there is a credit for it and the last one is on its way: whatever the client does,
/// this stays small. Thread-safe.
class Subscriber : public std::enable_shared_from_this<Subscriber> {
 public:
  /// `memory`: what its frames may take of the server's. Needs: `encoders` outlives it.
  Subscriber(uint64_t connection, Caller caller, std::shared_ptr<const FrameTarget> target,
             Quota::Share memory, Executor& encoders, SubscriberWiring wiring);

  const uint64_t connection;
  const Caller caller;
  const std::shared_ptr<const FrameTarget> target;

  // What the client says.
  void grant(const FrameCredit& credit);
  void beat(uint64_t client_time_us);
  void heard();

  /// Whether it has said nothing for so long, though it could have.
  bool is_silent(std::chrono::steady_clock::duration time) const;
  void cut() const {
    if (wiring_.on_dead) wiring_.on_dead();
  }

  /// Fails: why the client has to go.
  Status may_stay() const { return wiring_.may_stay ? wiring_.may_stay() : Status::ok(); }

  /// Closes, and cuts off whoever has not taken that after so long.
  void dismiss(const std::string& why, std::chrono::steady_clock::duration time);

  /// Whether more may be read from this client: it takes its answers, and does not send edits
  /// faster than they are done.
  bool may_send() const;

  /// An edit message has come that acknowledge() or refuse() will answer. False when the client is
  /// told to go: it will send the message again elsewhere.
  bool expect_answer(size_t bytes);

  // What there is to tell.
  void acknowledge(EditsAcknowledged answer, size_t bytes);
  void refuse(EditsRefused answer, size_t bytes);
  void refuse_unexpected(EditsRefused answer);
  void tell(std::shared_ptr<const SessionPeople> people);
  void tell(const HistoryState& history);

  /// Nothing more comes from the client. What it sent is still answered; then `farewell`, if any,
  /// is the last message.
  void close(std::optional<Farewell> farewell);

  bool is_closed() const;

  /// Whether a frame of this surface would show the client something new, and may be made.
  bool wants_frame(uint64_t version, bool settled) const;

  /// Takes a credit and makes a frame of the shot on an encoder's thread.
  void show(Shot shot);

  /// The next thing to send.
  std::optional<ServerMessage> take();

  /// Closed, and nothing will come any more.
  bool is_finished() const;

  uint32_t credits() const;

  /// What is held of frames for this client alone.
  uint64_t byte_count() const;

 private:
  void answer(ServerMessage message, size_t bytes);
  void encode(const Shot& shot);
  void on_message() const;
  void on_wish() const;

  const Quota::Share memory_;
  Executor& encoders_;
  const SubscriberWiring wiring_;
  const LiveObject live_{LiveKind::kStream};
  // Of the one encode() under way.
  FrameEncoder encoder_;
  uint64_t last_sequence_ = 0;  // of the last frame with data

  mutable std::mutex mutex_;  // of what follows
  uint32_t credits_ = 0;
  FrameCredit unseen_;              // by the encoder: what became of its frames
  bool holds_frame_ = false;        // as far as we know; else every frame is a key frame,
  bool key_frame_allowed_ = false;  // of which one goes out for each of the client's messages
  bool making_frame_ = false;       // from show() until it is taken
  std::optional<LiveFrame> frame_;
  uint64_t encoder_bytes_ = 0;
  std::optional<uint64_t> shown_version_;
  bool shown_settled_ = false;

  std::deque<ServerMessage> answers_;
  size_t unanswered_ = 0;
  size_t unanswered_bytes_ = 0;
  std::shared_ptr<const SessionPeople> people_;
  std::optional<HistoryState> history_;
  std::optional<Heartbeat> echo_;
  uint64_t client_time_us_ = 0;
  std::chrono::steady_clock::time_point last_beat_;
  std::chrono::steady_clock::time_point frame_beat_;  // that the frame under way has seen
  std::chrono::steady_clock::time_point last_heard_ = std::chrono::steady_clock::now();
  std::optional<Farewell> farewell_;
  std::optional<std::chrono::steady_clock::time_point> dismissed_;
  bool closed_ = false;
};

}  // namespace burnish

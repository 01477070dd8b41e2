#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "common/page_frames/page_frame_encoder.h"
#include "common/service/live.h"
#include "server/live/client_pages.h"
#include "server/live/surface_snapshot.h"
#include "server/manager/caller.h"
#include "server/metrics/live_objects.h"
#include "server/scheduling/executor.h"

namespace burnish {

/// The surface at one moment, sampled for the frames of some clients.
struct FrameSnapshot {
  std::shared_ptr<const SurfaceSnapshot> surface;
  std::shared_ptr<const ClientPages> pages;  ///< of this client; the surface has them
  uint64_t version = 0;                      ///< of the surface; grows with every cycle
  bool is_still = false;                     ///< the frame is exact, whatever its size
  FrameStats stats;
};

/// A subscriber's calls to others, from any thread, without its locks.
struct SubscriberWiring {
  std::function<void()> on_message;  ///< take() may have a message
  std::function<void()> on_dead;  ///< the client cannot be told anything more: cut the connection
  std::function<void()> on_wish;  ///< wants_frame() may have become true
  bool may_be_silent = false;     ///< the client cannot show that it is alive
  /// Returns whether the client would be let in again; empty: always. Called from time to time.
  std::function<Status()> may_stay;
};

/// One client of a live session on the server's side: its credits, its encoder, and its messages.
/// It keeps only the newest of messages that replace each other. It makes a frame only for a
/// credit, and only after the last frame was taken. So it stays small, whatever the client does.
/// Thread-safe.
class Subscriber : public std::enable_shared_from_this<Subscriber> {
 public:
  /// Begins with no page. Needs: `encoders` outlives it.
  Subscriber(uint64_t connection, Caller caller, std::unique_ptr<PageWishes> wishes,
             Executor& encoders, SubscriberWiring wiring);

  const uint64_t connection;
  const Caller caller;

  // Messages from the client.
  void grant(const FrameCredit& credit);
  /// Checks the change at once; an encoder's thread makes the pages. If it cannot, the client gets
  /// a go_away that says why. Fails: as PageWishes::want().
  Status show_pages(const ShowPages& change);
  /// Says whether vertices move otherwise than their corners say, which changes the pages.
  void set_layer(bool is_there);
  void beat(uint64_t client_time_us);
  void heard();

  /// Returns whether the client was silent for `time`, though it could speak.
  bool is_silent(std::chrono::steady_clock::duration time) const;
  void cut() const {
    if (wiring_.on_dead) wiring_.on_dead();
  }

  /// Fails: with the reason why the client must go.
  Status may_stay() const { return wiring_.may_stay ? wiring_.may_stay() : Status::ok(); }

  /// Closes, and cuts the client off if it has not taken the go_away after `time`.
  void dismiss(const std::string& why, std::chrono::steady_clock::duration time);

  /// Returns whether more may be read from this client: it takes its answers, and does not send
  /// edits faster than they are done.
  bool may_send() const;

  /// Notes an edit message that acknowledge() or refuse() will answer. Returns false if the client
  /// has been told to go: it will send the message again elsewhere.
  bool expect_answer(size_t bytes);

  // Messages to the client.
  void acknowledge(EditsAcknowledged answer, size_t bytes);
  void refuse(EditsRefused answer, size_t bytes);
  void refuse_unexpected(EditsRefused answer);
  void tell(std::shared_ptr<const SessionPeople> people);
  void tell(const HistoryState& history);

  /// Takes nothing more from the client. Still answers its edits; then `go_away`, if any, is the
  /// last message.
  void close(std::optional<GoAway> go_away);

  /// Does the same without waiting for answers that are not there yet: the client sends these edits
  /// again elsewhere.
  void abandon(GoAway go_away);

  bool is_closed() const;

  /// Returns the pages that the next frame shows.
  std::shared_ptr<const ClientPages> pages() const { return wishes_->made(); }

  /// Returns whether a frame of this surface would be new for the client and may be made.
  bool wants_frame(uint64_t version, bool settled) const;

  /// Takes a credit and makes a frame of the snapshot on an encoder's thread. Ignores a snapshot
  /// that is older than the last one.
  void show(FrameSnapshot snapshot);

  /// Returns the next message to send.
  std::optional<ServerMessage> take();

  /// Returns whether it is closed and has no more messages.
  bool is_finished() const;

  uint32_t credits() const;

  /// Returns the bytes held for this client alone: of frames and of lists of pages.
  uint64_t byte_count() const;

 private:
  void answer(ServerMessage message, size_t bytes);
  void close_held(std::optional<GoAway> go_away);  // needs the lock
  void post_pages();
  void encode(const FrameSnapshot& snapshot);
  void hear(const FrameCredit& unseen);
  void begin_kind(PageFrameKind kind);
  EncodedPageFrame encode(const FrameSnapshot& snapshot, uint32_t bytes_max);
  bool shows_the_last(const EncodedPageFrame& frame, uint32_t revision) const;
  void on_message() const;
  void on_wish() const;

  const std::unique_ptr<PageWishes> wishes_;
  Executor& encoders_;
  const SubscriberWiring wiring_;
  const LiveObject live_{LiveKind::kStream};
  // Used by the one encode() under way only.
  PageFrameEncoder encoder_;
  uint64_t last_sequence_ = 0;   // of the last frame with data
  uint32_t last_revision_ = 0;   // likewise
  bool last_was_exact_ = false;  // the last frame had the finest step

  mutable std::mutex mutex_;  // guards the following members
  uint32_t credits_ = 0;
  FrameCredit unseen_;           // not yet seen by the encoder: the outcome of its frames
  uint64_t first_sequence_ = 1;  // of the present kind
  bool holds_frame_ = false;  // as far as the server knows; if false, every frame is a key frame,
  bool key_frame_allowed_ = false;  // and each message of the client allows one
  bool making_frame_ = false;       // from show() until the frame is taken
  std::optional<LiveFrame> frame_;
  uint64_t encoder_bytes_ = 0;
  std::optional<uint64_t> shown_version_;
  uint32_t shown_revision_ = 0;
  bool shown_settled_ = false;

  std::deque<ServerMessage> answers_;
  size_t unanswered_ = 0;
  size_t unanswered_bytes_ = 0;
  std::shared_ptr<const SessionPeople> people_;
  std::optional<HistoryState> history_;
  std::optional<Heartbeat> echo_;
  uint64_t client_time_us_ = 0;
  std::chrono::steady_clock::time_point last_beat_;
  std::chrono::steady_clock::time_point frame_beat_;  // last beat before the frame under way
  std::chrono::steady_clock::time_point last_heard_ = std::chrono::steady_clock::now();
  std::optional<GoAway> go_away_;
  std::optional<std::chrono::steady_clock::time_point> dismissed_;
  bool closed_ = false;
  bool is_abandoned_ = false;  // closed, and its edits get no answers any more
};

}  // namespace burnish

#pragma once

#include <chrono>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "client/live/credit_pacer.h"
#include "client/live/frame_budget.h"
#include "client/live/frame_receiver.h"
#include "client/live/live_link.h"
#include "client/live/live_mutex.h"
#include "client/live/live_outbox.h"
#include "client/live/rate_meter.h"
#include "client/live/server_route.h"
#include "client/live/shown_edits.h"

namespace burnish {

/// All of a live session's client but threads, sockets and waiting: what is said next, what is made
/// of what is heard, and when to try again. A driver carries the messages: SessionLink by gRPC, a
/// browser's by WebSocket.
///
/// The driver calls begin(); then hear() and next() until the stream ends or must_leave() says so;
/// then end(). It does so again after the time that end() returns. The calls of LiveLink come from
/// any thread; no frame is decoded under the lock that they take.
class LiveConversation {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// The route leads to the server of each stream; the conversation changes it when the session
  /// moves, or the server is gone.
  LiveConversation(std::shared_ptr<ServerRoute> route, LiveOptions options);

  // As LiveLink has them. The driver is to look at next() after each.
  Status apply(std::vector<Edit> edits);
  void preview(const std::string& edit_id, PreviewChange change);
  void drop_preview(const std::string& edit_id);
  void move_brush(const std::optional<BrushRing>& ring);
  Status show_pages(const std::vector<std::shared_ptr<const Page>>& added,
                    const std::vector<PageId>& removed);
  LiveNews take(bool draws = true);
  void on_picture(std::chrono::microseconds took);

  size_t unacknowledged() const;  ///< edits
  /// Returns whether the session has ended for good.
  bool has_ended() const;

  // For the driver, on one thread.

  /// A stream begins, to the server to which the route leads now.
  void begin();
  /// Takes a message of the server, as from_wire() has parsed it. Returns whether the next picture
  /// may differ by it. An echo only tells the round trip: that shows with the next picture.
  bool hear(Result<std::optional<ServerMessage>> said);
  /// Returns the next message, if there is one to send now.
  std::optional<ClientMessage> next();
  /// Returns whether the stream is to end: it is silent, has said go_away, or was not understood.
  bool must_leave();
  /// Returns when to call next() and must_leave() again if nothing happens before.
  Time next_deadline() const;
  /// The stream has ended, or could not begin. Returns how long to wait before the next one;
  /// nothing: the session has ended.
  std::optional<std::chrono::milliseconds> end(const Status& of_stream);

 private:
  // Take messages (live_conversation_heard.cpp). An error ends the session.
  Status take_in(ProgressReport& report);
  Status take_in(Welcome& welcome);
  Status take_in(const LiveFrame& frame);
  Status take_in(EditsAcknowledged& answer);
  Status take_in(EditsRefused& answer);
  Status take_in(HistoryState& history);
  Status take_in(SessionPeople& people);
  Status take_in(const Heartbeat& echo);
  Status take_in(const GoAway& go_away);

  std::optional<ClientMessage> choose_message(Time now);
  Heartbeat heartbeat(Time now);
  Status why_it_ended(const Status& of_stream) const;
  std::chrono::milliseconds follow(const Status& moved);
  std::chrono::milliseconds retry_after();
  void tell(LiveEvent event);  // needs the lock
  void tell_shown();           // needs the lock

  const std::shared_ptr<ServerRoute> route_;
  const LiveOptions options_;

  // Only the driver uses these.
  std::string server_;  // of the stream: its address
  FrameReceiver receiver_;
  std::vector<std::shared_ptr<const Page>> added_pages_;  // of the next message, if it adds pages
  Time last_heard_;
  Time next_heartbeat_;
  std::string go_away_;  // why to come back on another stream; empty: no reason
  Status failure_;       // of the last message
  bool beat_for_credit_ = false;
  bool has_server_lost_it_ = false;  // the session
  int failures_ = 0;                 // streams without a frame, one after the other
  int moves_ = 0;                    // likewise, that another server has the session
  uint64_t frames_at_end_ = 0;
  std::minstd_rand random_{std::random_device{}()};

  mutable LiveMutex mutex_;  // of what follows
  LiveOutbox outbox_;
  CreditPacer pacer_;
  FrameBudget budget_;
  ShownEdits shown_;
  RateMeter rate_;
  LiveNews news_;
  Time last_decoded_;
  bool has_new_frame_ = false;
};

}  // namespace burnish

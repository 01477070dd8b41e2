#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "server/live/subscriber.h"
#include "server/manager/session_turn.h"
#include "server/scheduling/scheduler.h"

namespace burnish {

/// A session with clients: takes their edits and gestures, relaxes by a cycle a turn as long as the
/// surface moves, and shows it to everybody who has a credit. Settled, it sends one still frame and
/// is not heard of until something changes. Thread-safe; only turn() touches the session.
class LiveSession final : public Scheduled, public std::enable_shared_from_this<LiveSession> {
 public:
  /// Needs: manager and scheduler outlive it.
  LiveSession(SessionManager& manager, Scheduler& scheduler, std::shared_ptr<SessionEntry> entry,
              SessionRoles roles);

  void join(const std::shared_ptr<Subscriber>& subscriber);

  /// Ends the subscriber's gesture and presence. True when nobody is left.
  bool leave(uint64_t connection);

  /// Queues edits, all or none of which will be applied; the subscriber hears which. `bytes`: of
  /// their message.
  void edit(uint64_t connection, std::vector<Edit> edits, size_t bytes);

  /// Fails: permission_denied for a viewer; invalid_argument, resource_exhausted naming the value
  /// and its limit. A gesture that fails stays as it was.
  Status preview(uint64_t connection, Preview piece);
  void drop_preview(uint64_t connection, const std::string& edit_id);

  void move_brush(uint64_t connection, const std::optional<BrushRing>& ring);

  /// There is something to do, or somebody wants a frame.
  void wake();

  /// Closes all subscribers.
  void close(const Farewell& farewell);

  /// Closes those that have been silent for so long and those that may not stay, and cuts off those
  /// that do not take that.
  void end_unwelcome(std::chrono::steady_clock::duration silence_max);

  bool turn() override;

  /// Whether its turns wait for the session to come to memory.
  bool is_coming_back() const { return is_coming_back_; }
  size_t queued_edits() const;
  uint64_t credits() const;
  uint64_t client_bytes() const;  ///< what is held of frames for its clients

 private:
  struct Seat {
    std::shared_ptr<Subscriber> subscriber;
    uint64_t previews = 0;        // messages that have come
    uint64_t previews_taken = 0;  // that the session's previews have
  };
  struct EditMessage {
    std::shared_ptr<Subscriber> from;
    std::vector<Edit> edits;
    size_t bytes;
  };

  bool is_over() const;
  bool take_turn();
  void bring_back(SessionTurn& at);
  Status work(SessionTurn& at, bool& more);
  void fail(const Status& why);

  std::vector<EditMessage> take_edits();
  void refuse_waiting(const Status& why);
  void apply(SessionTurn& at, EditMessage message);
  void show_gestures(SessionTurn& at);
  void drop_gesture(uint64_t connection, const std::vector<std::string>& edit_ids);
  void tell_state(SessionTurn& at);
  Status relax(SessionTurn& at);
  FrameStats stats_of(SessionTurn& at) const;
  Status send_frames(SessionTurn& at);
  void tell_people();
  std::vector<std::shared_ptr<Subscriber>> subscribers() const;

  SessionManager& manager_;
  Scheduler& scheduler_;
  const std::shared_ptr<SessionEntry> entry_;
  const LiveObject live_{LiveKind::kLiveSession};

  // Of turn() alone.
  std::optional<FairMutex::Place> place_;  // in the line for the session
  /// What makes a new surface.
  struct Seen {
    uint64_t edits = 0;
    int cycle = 0;
    bool operator==(const Seen&) const = default;
  };
  uint64_t version_ = 0;  // of the surface
  Seen seen_;
  uint64_t life_ = 0;  // of the session that the gestures are shown in
  double assemble_ms_ = 0;
  double solve_ms_ = 0;
  uint64_t roles_version_ = 0;  // of roles_

  std::atomic<bool> is_coming_back_{false};  // the session, to memory

  mutable std::mutex mutex_;  // of what follows
  std::map<uint64_t, Seat> seats_;
  std::deque<EditMessage> edits_;
  std::map<uint64_t, Gesture> gestures_;
  std::set<uint64_t> changed_gestures_;  // that the session has not seen, ended ones too
  SessionRoles roles_;
  std::optional<HistoryState> history_;
};

}  // namespace burnish

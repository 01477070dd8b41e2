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

#include "server/live/held_points.h"
#include "server/live/layer_points.h"
#include "server/live/steady_surface.h"
#include "server/live/subscriber.h"
#include "server/manager/session_turn.h"
#include "server/scheduling/scheduler.h"

namespace burnish {

/// A session with clients. It takes their edits and gestures, relaxes by a cycle per turn while the
/// surface moves, and shows it to everybody who has a credit. Once settled, it sends one still
/// frame and rests until something changes. Thread-safe; only turn() touches the session.
class LiveSession final : public Scheduled, public std::enable_shared_from_this<LiveSession> {
 public:
  /// Needs: manager and scheduler outlive it.
  LiveSession(SessionManager& manager, Scheduler& scheduler,
              const SessionManager::Attached& attached);

  void join(const std::shared_ptr<Subscriber>& subscriber);

  /// Ends the subscriber's gesture and presence. Returns true if nobody is left.
  bool leave(uint64_t connection);

  /// Queues edits: all or none are applied, and the subscriber gets the outcome. `bytes`: size of
  /// their message.
  void edit(uint64_t connection, std::vector<Edit> edits, size_t bytes);

  /// Fails: permission_denied for a viewer; invalid_argument, resource_exhausted that name the
  /// value and its limit. A failed gesture stays unchanged.
  Status preview(uint64_t connection, Preview piece);
  /// Does nothing but count for a gesture that is not running.
  void drop_preview(uint64_t connection, const std::string& edit_id);

  void move_brush(uint64_t connection, const std::optional<BrushRing>& ring);

  /// Call when there is work.
  void wake();

  /// Call when somebody may want a frame. Before the session's first cycle they get the unmoved
  /// surface at once: the first turn of a large scan takes seconds.
  void wake_for_frames();

  /// Closes all subscribers.
  void close(const GoAway& go_away);

  /// Another server may have the session, one of `fleet`: closes all subscribers, and answers no
  /// edits any more. `why` names the server if it is known.
  void abandon(const Status& why, const std::vector<std::string>& fleet);

  /// Returns the predicted bytes of the session in memory.
  uint64_t session_bytes() const { return entry_->session_bytes; }

  /// Closes subscribers that were silent for `silence_max` and those that may not stay. Cuts off
  /// those that do not take the go_away.
  void end_unwelcome(std::chrono::steady_clock::duration silence_max);

  bool turn() override;

  /// Returns whether its turns wait for the session to come to memory.
  bool is_coming_back() const { return is_coming_back_; }
  size_t queued_edits() const;
  uint64_t credits() const;
  uint64_t client_bytes() const;  ///< bytes of frames held for its clients

 private:
  struct Slot {
    std::shared_ptr<Subscriber> subscriber;
    uint64_t previews = 0;        // received messages
    uint64_t previews_taken = 0;  // those that the session's previews have
  };
  struct Wish {
    Slot slot;
    std::shared_ptr<const ClientPages> pages;  // of the frame that it wishes
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
  void take_step(const StepReport& step, StepReport& last);
  void fail(const Status& why);

  std::vector<EditMessage> take_edits();
  void refuse_waiting(const Status& why);
  void apply(SessionTurn& at, EditMessage message);
  void show_gestures(SessionTurn& at);
  Status take_preview(uint64_t connection, Preview piece);
  void drop_gesture(uint64_t connection, const std::vector<std::string>& edit_ids);
  void tell_state(SessionTurn& at);
  Status relax(SessionTurn& at);
  FrameStats stats_of(SessionTurn& at) const;
  std::vector<Wish> wishes(uint64_t version, bool settled) const;
  void show_unmoved();
  void begin_steady_surface(SessionTurn& at);
  std::span<const Vec3f> shown_displacement(SessionTurn& at, FrameStats& stats);
  HeldPoints* held_points(const Session& session);
  LayerPoints* layer_points(SessionTurn& at, const VertexLayer& layer);
  Status send_frames(SessionTurn& at);
  void tell_people();
  std::vector<std::shared_ptr<Subscriber>> subscribers() const;

  SessionManager& manager_;
  Scheduler& scheduler_;
  const std::shared_ptr<SessionEntry> entry_;
  const LiveObject live_{LiveKind::kLiveSession};

  // Used by turn() only.
  std::optional<FairMutex::Ticket> ticket_;  // in the line for the session
  /// Everything that makes a new surface, or that clients wait to see in a frame.
  struct Seen {
    uint64_t edits = 0;
    int cycle = 0;
    uint64_t surface_revision = 0;
    uint64_t previews = 0;
    bool operator==(const Seen&) const = default;
  };
  uint64_t version_ = 0;  // of the surface; 0 is the unmoved one
  Seen seen_;
  uint64_t previews_taken_ = 0;  // messages of all clients, also of those that have left
  uint64_t life_ = 0;  // of the session that the next members are of; it shows the gestures
  std::optional<SteadySurface> steady_;
  std::optional<HeldPoints> held_;           // while rims are held
  std::optional<LayerPoints> layer_points_;  // once the session's edges are kept
  struct Still {
    uint64_t version;
    std::shared_ptr<const SurfaceSnapshot> snapshot;
  };
  std::optional<Still> still_;  // the newest frame's surface, while it is settled
  double assemble_ms_ = 0;
  double solve_ms_ = 0;
  uint64_t roles_version_ = 0;  // of roles_

  std::atomic<bool> is_coming_back_{false};  // to memory
  std::atomic<bool> is_unmoved_;             // before the first cycle

  mutable std::mutex mutex_;  // guards the following members
  std::map<uint64_t, Slot> slots_;
  std::deque<EditMessage> edits_;
  std::map<uint64_t, Gesture> gestures_;
  std::set<uint64_t> changed_gestures_;  // not yet seen by the session; also ended gestures
  SessionRoles roles_;
  std::optional<HistoryState> history_;
};

}  // namespace burnish

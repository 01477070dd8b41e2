#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/live/live_session.h"

namespace burnish {

/// A client's place in a live session.
struct LiveClient {
  std::shared_ptr<LiveSession> session;
  std::shared_ptr<Subscriber> subscriber;
  Welcome welcome;
};

/// The sessions that have clients, and their coming and going. Thread-safe.
class LiveSessions final : public SessionListener {
 public:
  /// `solver_threads` as of Scheduler. Needs: the manager outlives it, and nobody works with it
  /// when it ends.
  LiveSessions(SessionManager& manager, int solver_threads);
  ~LiveSessions() override;

  /// Brings the session back if need be, and joins. `wiring` of the client: all but on_wish.
  /// Whoever joins leaves. Fails: not_found, resource_exhausted, unavailable (draining), cancelled.
  Result<LiveClient> join(const Greeting& greeting, const Caller& caller, SubscriberWiring wiring,
                          const Progress& progress);
  void leave(const LiveClient& client);

  /// From now on nobody joins, and who is there is told to come back later.
  void drain();

  /// Ends the clients that have said nothing for kSilenceMax, and those that may not stay. To be
  /// called every second or so.
  void end_unwelcome();

  static constexpr std::chrono::seconds kSilenceMax{30};

  struct Usage {
    size_t waiting_sessions = 0;  ///< for a turn
    size_t queued_edits = 0;      ///< messages
    uint64_t credits = 0;
    uint64_t client_bytes = 0;  ///< what is held of frames for clients
  };
  Usage usage() const;

  Scheduler& scheduler() { return scheduler_; }

  void on_session_changed(const std::string& id) override;
  void on_session_left(const std::string& id, const Status& why) override;
  uint64_t client_bytes(const std::string& id) const override;

 private:
  std::shared_ptr<LiveSession> find(const std::string& id) const;

  SessionManager& manager_;
  FrameTargets targets_;

  mutable std::mutex mutex_;                                      // of what follows
  std::map<std::string, std::shared_ptr<LiveSession>> sessions_;  // by id
  bool draining_ = false;

  // Last, for their threads end before anything else does; turns post to the encoders.
  Executor encoders_;
  Scheduler scheduler_;
};

}  // namespace burnish

#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/live/live_session.h"
#include "server/live/successors.h"

namespace burnish {

/// A client's slot in a live session.
struct LiveClient {
  std::shared_ptr<LiveSession> session;
  std::shared_ptr<Subscriber> subscriber;
  Welcome welcome;
};

/// The sessions that have clients, and their coming and going. Thread-safe.
class LiveSessions final : public SessionListener {
 public:
  /// `solver_threads`: as for Scheduler. Needs: the manager outlives this, and nobody uses the
  /// manager when this ends.
  LiveSessions(SessionManager& manager, int solver_threads);
  ~LiveSessions() override;

  /// Brings the session back if needed, makes missing pages of its scan, and joins. The client sets
  /// all of `wiring` except on_wish. Each joined client must leave. Fails: not_found,
  /// resource_exhausted, unavailable (draining), cancelled.
  Result<LiveClient> join(const Greeting& greeting, const Caller& caller, SubscriberWiring wiring,
                          const Progress& progress);
  void leave(const LiveClient& client);

  /// Sets the addresses that clients are told in their welcome.
  void set_fleet(std::vector<std::string> addresses);

  /// From now on nobody can join. Tells all clients to go on at one of the other servers, or to
  /// come back later if there is none.
  void drain(Successors successors = {});

  /// Ends clients that were silent for kSilenceMax, and those that may not stay. Call about every
  /// second.
  void end_unwelcome();

  static constexpr std::chrono::seconds kSilenceMax{30};

  struct Usage {
    size_t waiting_sessions = 0;  ///< sessions that wait for a turn
    size_t queued_edits = 0;      ///< messages
    uint64_t credits = 0;
    uint64_t client_bytes = 0;  ///< bytes of frames held for clients
  };
  Usage usage() const;

  Scheduler& scheduler() { return scheduler_; }

  void on_session_changed(const std::string& id) override;
  void on_session_left(const std::string& id, const Status& why) override;
  void on_session_lost(const std::string& id, const Status& why) override;
  void on_session_moved(const std::string& id, const Status& why) override;
  uint64_t client_bytes(const std::string& id) const override;

 private:
  std::shared_ptr<LiveSession> find(const std::string& id) const;
  std::vector<std::string> fleet() const;

  SessionManager& manager_;
  PageSources sources_;

  mutable std::mutex mutex_;                                      // guards the following members
  std::map<std::string, std::shared_ptr<LiveSession>> sessions_;  // by id
  bool draining_ = false;
  std::vector<std::string> fleet_;

  // Last members: their threads end before the others are destroyed. Turns post to the encoders.
  Executor encoders_;
  Scheduler scheduler_;
};

}  // namespace burnish

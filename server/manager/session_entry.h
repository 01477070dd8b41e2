#pragma once

#include <atomic>
#include <chrono>
#include <memory>

#include "common/service/session_info.h"
#include "server/journal/journal.h"
#include "server/library/mesh_cache.h"
#include "server/manager/presence.h"
#include "server/memory/quota.h"
#include "server/scheduling/fair_mutex.h"
#include "server/session/session.h"

namespace burnish {

/// A session as its manager keeps it, in memory or not.
struct SessionEntry {
  explicit SessionEntry(SessionRecord session_record) : record(std::move(session_record)) {}

  SessionInfo info() const {
    return {record.id, record.name, record.scan_id, record.key, record.created_unix_seconds,
            edits,     in_memory};
  }

  void leave_memory() {
    forget_state();
    mesh.reset();
    memory = {};
    by_user = {};
    session_bytes = 0;
  }

  /// What replay makes again goes; what it needs for that stays.
  void forget_state() {
    session.reset();
    last = {};
    in_memory = false;
  }

  const SessionRecord record;
  std::atomic<uint64_t> edits{0};
  std::atomic<bool> in_memory{false};
  std::atomic<bool> in_journal{false};  // else it is being made, and nobody has been told of it
  std::atomic<uint64_t> session_bytes{0};
  /// The session in memory has seen edits that could not be written: it is to be replayed.
  std::atomic<bool> ahead_of_journal{false};
  Presence presence;
  std::atomic<std::chrono::steady_clock::time_point> last_use{std::chrono::steady_clock::now()};

  FairMutex mutex;  // of what follows
  bool deleted = false;
  bool solving = false;  // somebody has lent the mutex in the middle of a solve
  SessionRoles roles;
  uint64_t roles_version = 0;
  std::shared_ptr<const SharedMesh> mesh;
  Quota::Share memory;               // what the session takes of the server's
  Quota::Share by_user;              // of whoever opened it
  std::unique_ptr<Session> session;  // null: not in memory
  uint64_t life = 0;                 // how often it has come to memory
  StepReport last;
};

}  // namespace burnish

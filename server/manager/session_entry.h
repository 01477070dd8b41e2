#pragma once

#include <atomic>
#include <chrono>
#include <memory>

#include "common/service/session_info.h"
#include "server/journal/journal.h"
#include "server/library/mesh_cache.h"
#include "server/manager/kept_shares.h"
#include "server/manager/layer_need.h"
#include "server/manager/presence.h"
#include "server/memory/quota.h"
#include "server/scheduling/fair_mutex.h"
#include "server/session/session.h"

namespace burnish {

/// A session of the manager, in memory or not.
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

  /// Forgets the state that a replay makes again.
  void forget_state() {
    session.reset();
    last = {};
    in_memory = false;
  }

  SessionRecord record;  // its name changes under this mutex and the map's together
  std::atomic<uint64_t> edits{0};
  std::atomic<bool> in_memory{false};
  std::atomic<bool> in_journal{false};  // else it is being made, and nobody knows of it
  std::atomic<uint64_t> session_bytes{0};
  KeptShares::Part kept;  // of its maker; set before others know the entry
  /// The session in memory has edits that could not be written: it must be replayed.
  std::atomic<bool> ahead_of_journal{false};
  /// Nobody knows whether its last edits are on disk. Later ones cannot be refused before the
  /// replay: they follow edits that may be there.
  std::atomic<bool> is_in_doubt{false};
  Presence presence;
  std::atomic<std::chrono::steady_clock::time_point> last_use{std::chrono::steady_clock::now()};

  FairMutex mutex;  // guards the following members
  bool deleted = false;
  bool solving = false;  // a solve has lent the mutex
  SessionRoles roles;
  uint64_t roles_version = 0;
  std::shared_ptr<const SharedMesh> mesh;
  Quota::Share memory;               // the session's share of the server's memory
  uint64_t own_bytes = 0;            // of that, without its edits
  Quota::Share by_user;              // share of the user who opened it
  std::string opened_by;             // that user; empty: nobody with a name
  std::unique_ptr<Session> session;  // null: not in memory
  uint64_t life = 0;                 // how often it has come to memory
  StepReport last;
  LayerNeed layers;  // of its edits
};

}  // namespace burnish

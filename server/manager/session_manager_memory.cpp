// The part of SessionManager that brings a session to memory: its scan, a solver, its edits.

#include <spdlog/spdlog.h>

#include "server/manager/session_entry.h"
#include "server/manager/session_manager.h"
#include "server/memory/memory_need.h"

namespace burnish {

/// A session on its way to memory. It is the entry's once all of it is there.
struct SessionManager::Coming {
  std::vector<AuthoredEdit> edits;
  std::shared_ptr<const SharedMesh> mesh;
  Quota::Share by_user, memory;
  uint64_t own_bytes = 0;  ///< of the memory, without its edits
  std::unique_ptr<Session> session;
};

static uint64_t bytes_of_history(const std::vector<AuthoredEdit>& edits) {
  uint64_t bytes = 0;
  for (const AuthoredEdit& edit : edits) bytes += bytes_in_history(edit);
  return bytes;
}

// A session in memory counts for the user who brought it there.
Status SessionManager::bring_back(SessionEntry& entry, const Caller& caller,
                                  const Progress& progress) {
  if (entry.ahead_of_journal.exchange(false)) entry.forget_state();
  if (entry.session) return Status::ok();
  entry.session_bytes = 0;
  Coming coming{.mesh = std::move(entry.mesh),
                .by_user = std::move(entry.by_user),
                .memory = std::move(entry.memory)};
  RETURN_IF_ERROR(charge(entry, caller, coming.by_user));
  ASSIGN_OR_RETURN(coming.edits, journal_.edits(entry.record.id));  // also checks the record
  entry.is_in_doubt = false;  // all earlier outcomes are known
  const Status opened = open_solver(entry, coming, progress);
  if (!opened.is_ok()) return elsewhere(entry, opened);
  RETURN_IF_ERROR(replay(entry.record.id, coming));
  entry.mesh = std::move(coming.mesh);
  entry.session_bytes = coming.memory.amount();
  entry.own_bytes = coming.own_bytes;
  entry.memory = std::move(coming.memory);
  entry.by_user = std::move(coming.by_user);
  entry.session = std::move(coming.session);
  entry.edits = coming.edits.size();
  entry.kept.set_history_bytes(entry.session->edited().history().byte_count());
  ++entry.life;
  entry.in_memory = true;
  store_.keep_hierarchy(entry.record.scan_id, entry.record.key, entry.mesh);
  return Status::ok();
}

Status SessionManager::charge(SessionEntry& entry, const Caller& caller, Quota::Share& by_user) {
  if (by_user.amount() == 0 && !caller.user.empty()) {
    ASSIGN_OR_RETURN(by_user, by_user_.take("user " + caller.user, 1));
    entry.opened_by = caller.user;
  }
  if (!entry.in_journal) return Status::ok();
  RETURN_IF_ERROR(hold(entry));
  return journal_.charge(entry.record.id, entry.opened_by, options_.sessions_per_user);
}

// A solver that goes to the processors after all takes more memory.
Status SessionManager::open_solver(SessionEntry& entry, Coming& coming, const Progress& progress) {
  const SessionRecord& record = entry.record;
  if (!coming.mesh) {
    ASSIGN_OR_RETURN(coming.mesh,
                     store_.open_mesh(record.scan_id, record.key, progress, entry.opened_by));
  }
  const SharedMesh& mesh = *coming.mesh;
  entry.layers = {};
  entry.layers.add(coming.edits);
  const uint64_t of_edits = entry.layers.byte_count(mesh) + bytes_of_history(coming.edits);
  SessionNeed need = predict_session_need(mesh, devices_for(mesh, options_.solver));
  if (coming.memory.amount() == 0) {
    ASSIGN_OR_RETURN(coming.memory, store_.memory().take(kServer, need.opening + of_edits));
  } else {
    RETURN_IF_ERROR(coming.memory.resize(need.opening + of_edits));
  }
  const auto on_processors = [&]() -> Status {
    need = predict_session_need(mesh, 0);
    return coming.memory.resize(need.opening + of_edits);
  };
  ASSIGN_OR_RETURN(coming.session,
                   Session::open(mesh, options_.solver, record.controls, on_processors));
  coming.own_bytes = need.open;
  const Solver& solver = coming.session->solver();
  spdlog::info("session {}: backend {} ({})", record.id, solver.backend_name(),
               solver.backend_reason());
  return coming.memory.resize(need.open + of_edits);
}

Status SessionManager::replay(const std::string& id, Coming& coming) {
  EditedFields& edited = coming.session->edited();
  ASSIGN_OR_RETURN(auto kept, journal_.paint(id, coming.mesh->prepared->cells.size()));
  for (PaintCheckpoint& paint : kept) edited.offer(std::move(paint));
  const uint64_t skipped = edited.restore(coming.edits);
  if (skipped > 0)
    spdlog::warn(
        "session {}: {} of its {} edits are damaged and have no effect; its history says which", id,
        skipped, coming.edits.size());
  return Status::ok();
}

}  // namespace burnish

#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/service/session_history.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"
#include "server/journal/journal.h"
#include "server/library/export_file.h"
#include "server/library/mesh_store.h"
#include "server/manager/caller.h"
#include "server/manager/presence.h"
#include "server/manager/session_listener.h"
#include "server/scheduling/executor.h"
#include "server/scheduling/fair_mutex.h"
#include "server/session/session.h"

namespace burnish {

struct SessionManagerOptions {
  size_t sessions_max = 64;
  uint64_t sessions_per_user = 1'000'000;  ///< in memory
  SolverOptions solver;
};

struct SessionEntry;
class SessionTurn;

/// All sessions by name and id. The journal knows every session; those in use are in memory as
/// well, and come back there by replay. Thread-safe: one lock per session, held while it works and
/// never while it waits for the disk. What a caller may do is up to the session's roles, and a
/// refusal is permission_denied. A name is never an id: 16 hexadecimal digits are refused as one.
class SessionManager {
 public:
  /// Lists the journal's sessions. Needs: folder, store and journal outlive the manager.
  static Result<std::unique_ptr<SessionManager>> create(const DataFolder& folder, MeshStore& store,
                                                        Journal& journal,
                                                        const SessionManagerOptions& options);
  ~SessionManager();

  /// Opens, or attaches to the session of that name when it is over the same prepared mesh. A new
  /// session is written down once it has opened: what cannot be opened leaves nothing behind.
  /// Fails: not_found, invalid_argument (the name is an id), already_exists (the name is
  /// another's), resource_exhausted, cancelled.
  Result<OpenedSession> open(const SessionWish& wish, const Caller& caller,
                             const Progress& progress = {});

  /// A new session with a part of another's edits; the caller becomes its owner.
  /// Fails: not_found (session, edit, checkpoint), invalid_argument (the name is an id),
  /// already_exists, resource_exhausted, cancelled.
  Result<SessionInfo> fork(const ForkWish& wish, const Caller& caller,
                           const Progress& progress = {});

  /// By name.
  std::vector<SessionInfo> list() const;

  /// What the sessions in memory take, by the admission's prediction.
  struct Usage {
    size_t in_memory = 0;
    uint64_t session_bytes = 0;
  };
  Usage usage() const;

  /// What meshes, sessions and whoever shows them share.
  Quota& memory() { return store_.memory(); }

  /// Sends everybody out of the session and gives its memory back; whoever opens it again brings
  /// it back.
  Status close(const std::string& reference, const Caller& caller, const Progress& progress = {});

  /// Forgets the session and its edits.
  Status remove(const std::string& reference, const Caller& caller, const Progress& progress = {});

  /// Applies all new edits or none. When it returns they are on disk. Ids that the caller has used
  /// before are skipped. Fails: as EditedFields::record() and Journal::append().
  Result<ApplyOutcome> apply(const std::string& reference, const Caller& caller,
                             std::span<const Edit> edits, const Progress& progress = {});

  /// The same without waiting for the disk: the session has the edits when this returns, and
  /// `on_disk` is called from another thread when they are safe. When it hears of a failure, the
  /// session forgets them. Not called when this fails.
  Result<ApplyOutcome> submit(const std::string& reference, const Caller& caller,
                              std::span<const Edit> edits, const Progress& progress,
                              GroupCommit::Done on_disk);

  Result<HistoryPage> history(const HistoryWish& wish, const Caller& caller,
                              const Progress& progress = {});

  Result<SessionPeople> people(const std::string& reference, const Progress& progress = {});

  /// Gives `subject`, or everybody without a role of their own when it is "", a role.
  /// Fails: resource_exhausted (kSessionRolesMax), failed_precondition (no owner would be left).
  Status set_role(const std::string& reference, const Caller& caller, const std::string& subject,
                  SessionRole role, const Progress& progress = {});

  /// Runs `work` with the session in memory, up to date, and nobody else at it.
  Status visit(const std::string& reference, const Caller& caller,
               const std::function<Status(Session&)>& work, const Progress& progress = {});

  /// Who is there; lives as long as the session. Fails: not_found.
  Result<std::shared_ptr<Presence>> presence(const std::string& reference) const;

  /// A session for whoever works at it in turns: in memory, and found without a search.
  struct Attached {
    std::shared_ptr<SessionEntry> entry;
    std::shared_ptr<const SharedMesh> mesh;
    SessionInfo info;
    SessionRoles roles;
    std::string backend;
  };

  /// Fails: not_found, resource_exhausted, cancelled.
  Result<Attached> attach(const std::string& reference, const Caller& caller,
                          const Progress& progress = {});

  /// Never waits: nothing when somebody else is at the session, and `place` calls once it is worth
  /// another try. Fails: not_found (deleted). Needs: a place in the line of the entry's mutex.
  Result<std::optional<SessionTurn>> try_turn(const std::shared_ptr<SessionEntry>& entry,
                                              FairMutex::Place& place);

  /// Takes the sessions out of memory that nobody is in, and that nobody has used for so long.
  void spill_idle(std::chrono::seconds idle_time);

  /// Who shows sessions to clients; null: nobody. When this returns, nobody speaks to the last one.
  void set_listener(SessionListener* listener) { listener_->set(listener); }

  Result<SessionState> state(const std::string& reference, const Caller& caller,
                             const Progress& progress = {});

  /// Solves and writes the edited mesh to a staging file. Edits are taken in meanwhile.
  Result<std::unique_ptr<ExportFile>> export_mesh(const std::string& reference,
                                                  const ExportWish& wish, const Caller& caller,
                                                  const Progress& progress = {});

  /// Deletes a scan of the store. Fails: failed_precondition naming a session that edits it.
  Result<std::string> delete_scan(const std::string& reference);

 private:
  friend class SessionTurn;
  /// A session's entry with its lock held and the session in memory.
  struct Held;

  SessionManager(const DataFolder& folder, MeshStore& store, Journal& journal,
                 const SessionManagerOptions& options)
      : folder_(folder),
        store_(store),
        journal_(journal),
        options_(options),
        by_user_("sessions open", "limits.sessions_per_user", options.sessions_per_user) {}

  bool is_edited(const std::string& scan_id, const PreparedKey& key) const;
  std::shared_ptr<SessionEntry> find(const std::string& reference) const;
  Result<Held> lock(const std::string& reference, const Progress& progress) const;
  Result<Held> lock(std::shared_ptr<SessionEntry> entry, const Progress& progress) const;
  Result<Held> use(const std::string& reference, const Caller& caller, const Progress& progress);

  // New sessions: the name is taken at once, the disk is written without the map's lock.
  struct Reserved;
  Result<Reserved> find_or_reserve(const SessionWish& wish, const Caller& caller);
  Result<Held> reserve(SessionRecord record, const Caller& caller);  // needs the map's lock
  Status check_room() const;                                         // likewise
  Status make(SessionEntry& entry, const Caller& caller, const Progress& progress);
  void give_up(SessionEntry& entry);

  Status bring_back(SessionEntry& entry, const Caller& caller, const Progress& progress);
  void bring_back_later(const std::shared_ptr<SessionEntry>& entry,
                        const std::function<void(const Status&)>& came_back);
  Status catch_up(SessionEntry& entry, const Progress& progress);
  Result<ApplyOutcome> submit_held(const std::shared_ptr<SessionEntry>& held, const Caller& caller,
                                   std::span<const Edit> edits, GroupCommit::Done on_disk);
  void tell_changed(const SessionEntry& entry) const;
  uint64_t client_bytes(const SessionEntry& entry) const;
  void tell_left(const SessionEntry& entry, const Status& why) const;
  void keep_paint(SessionEntry& entry);
  Result<SolveReport> solve(Held& held, const ExportWish& wish, const Progress& progress);
  Result<ExportSummary> solve_to_file(Held& held, const ExportWish& wish,
                                      const std::filesystem::path& path, const Progress& progress);

  const DataFolder& folder_;
  MeshStore& store_;
  Journal& journal_;
  const SessionManagerOptions options_;
  Quota by_user_;
  const std::shared_ptr<ListenerSlot> listener_ = std::make_shared<ListenerSlot>();
  std::atomic<bool> ending_{false};

  mutable std::mutex mutex_;  // of what follows; never held while a session works or a disk writes
  std::map<std::string, std::shared_ptr<SessionEntry>> sessions_;  // by id
  std::map<std::string, std::shared_ptr<SessionEntry>> by_name_;
  std::set<std::string> scans_going_;  // that are being deleted

  Executor background_{1};  // last: its thread ends before anything else does
};

}  // namespace burnish

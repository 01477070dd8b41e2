#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/service/session_history.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"
#include "server/session/export_file.h"
#include "server/session/journal.h"
#include "server/session/mesh_store.h"
#include "server/session/presence.h"
#include "server/session/session.h"
#include "server/session/session_listener.h"

namespace burnish {

struct SessionManagerOptions {
  size_t sessions_max = 64;
  uint64_t sessions_per_user = 1'000'000;  ///< in memory
  SolverOptions solver;
};

struct SessionEntry;
class SessionTurn;

/// All sessions by name and id. The journal knows every session; those in use are in memory as
/// well, and come back there by replay. Thread-safe: one lock per session, held while it works.
/// `user` is who asks, "" for somebody without a name; what they may do is up to the session's
/// roles, and a refusal is permission_denied.
class SessionManager {
 public:
  /// Lists the journal's sessions. Needs: folder, store and journal outlive the manager.
  static Result<std::unique_ptr<SessionManager>> create(const DataFolder& folder, MeshStore& store,
                                                        Journal& journal,
                                                        const SessionManagerOptions& options);
  ~SessionManager();

  /// Opens, or attaches to the session of that name when it is over the same prepared mesh.
  /// Fails: not_found, already_exists (the name is another's), resource_exhausted, cancelled.
  Result<OpenedSession> open(const SessionWish& wish, const std::string& user,
                             const Progress& progress);

  /// A new session with a part of another's edits; `user` becomes its owner.
  /// Fails: not_found (session, edit, checkpoint), already_exists, resource_exhausted, cancelled.
  Result<SessionInfo> fork(const ForkWish& wish, const std::string& user, const Progress& progress);

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
  Status close(const std::string& reference, const std::string& user, const Progress& progress);

  /// Forgets the session and its edits.
  Status remove(const std::string& reference, const std::string& user, const Progress& progress);

  /// Applies all new edits or none. When it returns they are on disk. Ids that the user has used
  /// before are skipped. Fails: as EditedFields::apply() and Journal::append().
  Result<ApplyOutcome> apply(const std::string& reference, const std::string& user,
                             std::span<const Edit> edits, const Progress& progress);

  /// The same without waiting for the disk: the session shows the edits when this returns, and
  /// `on_disk` is called from another thread when they are safe. When it hears of a failure, the
  /// session forgets them. Not called when this fails.
  Result<ApplyOutcome> submit(const std::string& reference, const std::string& user,
                              std::span<const Edit> edits, const Progress& progress,
                              GroupCommit::Done on_disk);

  Result<HistoryPage> history(const HistoryWish& wish, const Progress& progress);

  Result<SessionPeople> people(const std::string& reference, const Progress& progress);

  /// Gives `subject`, or everybody without a role of their own when it is "", a role.
  Status set_role(const std::string& reference, const std::string& user, const std::string& subject,
                  SessionRole role, const Progress& progress);

  /// Runs `work` with the session in memory and nobody else at it.
  Status visit(const std::string& reference, const Progress& progress,
               const std::function<Status(Session&)>& work);

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
  Result<Attached> attach(const std::string& reference, const Progress& progress);

  /// Never waits: nothing when somebody else is at the session; `when_free` is called then as soon
  /// as it is worth another try. Fails: not_found (deleted), or as attach() where the session has
  /// to come back to memory.
  Result<std::optional<SessionTurn>> try_turn(const std::shared_ptr<SessionEntry>& entry,
                                              std::function<void()> when_free);

  /// Takes the sessions out of memory that nobody is in, and that nobody has used for so long.
  void spill_idle(std::chrono::seconds idle_time);

  /// Who shows sessions to clients; null: nobody. Needs: it outlives the calls.
  void set_listener(SessionListener* listener) { listener_ = listener; }

  Result<SessionState> state(const std::string& reference, const Progress& progress);

  /// Solves and writes the edited mesh to a staging file.
  Result<std::unique_ptr<ExportFile>> export_mesh(const std::string& reference,
                                                  const ExportWish& wish, const Progress& progress);

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
  Result<std::shared_ptr<SessionEntry>> find_or_create(const SessionWish& wish,
                                                       const std::string& user, bool& created);
  Status check_room() const;  // needs the map's lock
  Result<Held> lock(const std::string& reference, const Progress& progress) const;
  Result<Held> use(const std::string& reference, const Progress& progress);
  Status bring_back(SessionEntry& entry, const Progress& progress);
  Result<ApplyOutcome> submit_held(const std::shared_ptr<SessionEntry>& held,
                                   const std::string& user, std::span<const Edit> edits,
                                   const Progress& progress, GroupCommit::Done on_disk);
  void tell_changed(const SessionEntry& entry) const;
  uint64_t client_bytes(const SessionEntry& entry) const;
  void tell_left(const SessionEntry& entry, const Status& why) const;
  void keep_paint(SessionEntry& entry);
  Status bring_back_for(SessionEntry& entry, const std::string& user, const Progress& progress);
  Result<ExportSummary> solve_to_file(Held& held, const ExportWish& wish,
                                      const std::filesystem::path& path, const Progress& progress);

  const DataFolder& folder_;
  MeshStore& store_;
  Journal& journal_;
  const SessionManagerOptions options_;
  Quota by_user_;
  std::atomic<SessionListener*> listener_{nullptr};

  mutable std::mutex mutex_;  // of the map; never held while a session works
  std::map<std::string, std::shared_ptr<SessionEntry>> sessions_;  // by name
};

}  // namespace burnish

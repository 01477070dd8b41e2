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
#include "common/measure/section.h"
#include "common/service/session_history.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"
#include "common/service/surface_measures.h"
#include "server/journal/journal.h"
#include "server/library/export_file.h"
#include "server/library/mesh_store.h"
#include "server/manager/caller.h"
#include "server/manager/kept_limits.h"
#include "server/manager/kept_shares.h"
#include "server/manager/presence.h"
#include "server/manager/session_listener.h"
#include "server/scheduling/executor.h"
#include "server/scheduling/fair_mutex.h"
#include "server/session/session.h"

namespace burnish {

struct SessionManagerOptions {
  uint64_t sessions_per_user = 1'000'000;  ///< in memory
  KeptLimits kept;
  SolverOptions solver;
};

struct SessionEntry;
class SessionTurn;

/// All sessions by name and id. The journal knows every session. Sessions in use are in memory as
/// well; a replay brings them there. Thread-safe: one lock per session, held while it works and
/// never while it waits for the disk. The session's roles say what a caller may do; a refusal is
/// permission_denied. A name is never an id: 16 hexadecimal digits are refused as a name.
class SessionManager {
 public:
  /// Lists the journal's sessions. Needs: folder, store and journal outlive the manager.
  static Result<std::unique_ptr<SessionManager>> create(const DataFolder& folder, MeshStore& store,
                                                        Journal& journal,
                                                        const SessionManagerOptions& options);
  ~SessionManager();

  /// Opens a session, or attaches to the session of that name if it has the same prepared mesh. A
  /// new session is written down once it has opened, so a failed opening leaves nothing behind.
  /// Fails: not_found, invalid_argument (the name is an id), already_exists (another session has
  /// the name), resource_exhausted, cancelled.
  Result<OpenedSession> open(const SessionWish& wish, const Caller& caller,
                             const Progress& progress = {});

  /// Makes a session with a part of another's edits; the caller becomes its owner. Prepares the
  /// scan if the fork has a depth of its own. Fails: not_found (session, edit, checkpoint),
  /// invalid_argument (the name is an id), already_exists, resource_exhausted, cancelled.
  Result<ForkedSession> fork(const ForkWish& wish, const Caller& caller,
                             const Progress& progress = {});

  /// Returns the sessions by name.
  std::vector<SessionInfo> list() const;

  /// The predicted memory of the sessions in memory.
  struct Usage {
    size_t in_memory = 0;
    uint64_t session_bytes = 0;
  };
  Usage usage() const;

  /// Returns the most sessions and the most bytes of history that one user has, in memory or not.
  KeptShares::Share largest_share() const { return shares_.largest(); }

  /// The scans.
  MeshStore& store() { return store_; }

  /// The common budget of meshes, sessions and the listener.
  Quota& memory() { return store_.memory(); }

  /// Sends everybody out of the session and frees its memory. The next opening brings it back.
  Status close(const std::string& reference, const Caller& caller, const Progress& progress = {});

  /// Gives the session another name; people in it stay. Fails: not_found, invalid_argument (the
  /// name is an id), already_exists (another session has the name).
  Result<SessionInfo> rename(const std::string& reference, const std::string& name,
                             const Caller& caller, const Progress& progress = {});

  /// Forgets the session and its edits.
  Status remove(const std::string& reference, const Caller& caller, const Progress& progress = {});

  /// Applies all new edits or none. When it returns they are on disk. Skips ids that the caller has
  /// used before. Fails: as EditedFields::record() and Journal::append().
  Result<ApplyOutcome> apply(const std::string& reference, const Caller& caller,
                             std::span<const Edit> edits, const Progress& progress = {});

  /// Says whether edits are on disk. If it fails with `unavailable`, nobody knows: the caller must
  /// send the same edits again.
  using OnDisk = std::function<void(const Status&)>;

  /// Does the same without waiting for the disk: the session has the edits when this returns.
  /// Another thread calls `on_disk` when they are safe. If `on_disk` gets a failure, the session
  /// forgets the edits. It is not called when this fails.
  Result<ApplyOutcome> submit(const std::string& reference, const Caller& caller,
                              std::span<const Edit> edits, const Progress& progress,
                              OnDisk on_disk);

  Result<HistoryPage> history(const HistoryWish& wish, const Caller& caller,
                              const Progress& progress = {});

  Result<SessionPeople> people(const std::string& reference, const Progress& progress = {});

  /// Gives a role to `subject`, or if it is "" to everybody without their own role. Fails:
  /// resource_exhausted (kSessionRolesMax), failed_precondition (no owner would be left).
  Status set_role(const std::string& reference, const Caller& caller, const std::string& subject,
                  SessionRole role, const Progress& progress = {});

  /// Runs `work` alone on the session, in memory and up to date.
  Status visit(const std::string& reference, const Caller& caller,
               const std::function<Status(Session&)>& work, const Progress& progress = {});

  /// Returns how much of the seams of a scan's pictures a session levels, by its edits so far.
  /// Fails: as visit(); invalid_argument if the session edits another scan.
  Result<SeamLevelling> seams(const std::string& reference, const std::string& scan_id,
                              const Caller& caller, const Progress& progress = {});

  /// Returns the people in the session; lives as long as the session. Fails: not_found.
  Result<std::shared_ptr<Presence>> presence(const std::string& reference) const;

  /// A session for work in turns: in memory, and found without a search.
  struct Attached {
    std::shared_ptr<SessionEntry> entry;
    std::shared_ptr<const SharedMesh> mesh;
    SessionInfo info;
    SessionRoles roles;
    std::string backend;
    int cycles = 0;  ///< since it came into memory
  };

  /// Fails: not_found, resource_exhausted, cancelled.
  Result<Attached> attach(const std::string& reference, const Caller& caller,
                          const Progress& progress = {});

  /// Never waits. Returns nothing if somebody else works on the session; `ticket` calls when
  /// another try is worth it. Fails: not_found (deleted). Needs: a ticket of the entry's mutex.
  Result<std::optional<SessionTurn>> try_turn(const std::shared_ptr<SessionEntry>& entry,
                                              FairMutex::Ticket& ticket);

  /// Takes in which sessions other servers have made, renamed and deleted. Does nothing for a
  /// journal of this server alone.
  void refresh();

  /// Sends everybody out of the sessions in memory at once: another server may have them.
  void let_go(const Status& why);

  /// Sets a function that fails while others may have this server's sessions. All are let go then
  /// before anybody sees them, and none is used. Needs: one call, before others; it outlives the
  /// manager.
  void set_hold_check(std::function<Status()> may_hold) { may_hold_ = std::move(may_hold); }

  /// Asks that function. Call it often: a session may be shown while nobody uses it. Fails: as it
  /// does.
  Status check_hold();

  /// Unloads sessions that nobody is in and nobody has used for `idle_time`.
  void spill_idle(std::chrono::seconds idle_time);

  /// Sets who shows sessions to clients; null: nobody. After the return nobody calls the old one.
  void set_listener(SessionListener* listener) { listener_->set(listener); }

  Result<SessionState> state(const std::string& reference, const Caller& caller,
                             const Progress& progress = {});

  /// Solves and writes the edited mesh to a staging file. Takes edits in meanwhile.
  Result<std::unique_ptr<ExportFile>> export_mesh(const std::string& reference,
                                                  const ExportWish& wish, const Caller& caller,
                                                  const Progress& progress = {});

  /// Measures the present surface against the scan. Fails: as visit(); resource_exhausted (not
  /// enough memory for a copy of the surface).
  Result<SessionDeviation> deviation(const std::string& reference, const Caller& caller,
                                     const Progress& progress = {});

  /// Cuts the scan and the present surface. Fails: likewise; as cut_surface().
  Result<Section> section(const SectionWish& wish, const Caller& caller,
                          const Progress& progress = {});

  /// Deletes a scan of the store. Fails: failed_precondition that names a session that edits it.
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
  Result<Held> lock(const std::string& reference, const Progress& progress);
  Result<Held> lock(std::shared_ptr<SessionEntry> entry, const Progress& progress) const;
  Status hold(SessionEntry& entry);
  Status note_loss(SessionEntry& entry, const Status& status) const;
  Status elsewhere(const SessionEntry& entry, const Status& why);
  Result<Held> use(const std::string& reference, const Caller& caller, const Progress& progress);

  // New sessions take the name at once, and write to the disk without the map's lock.
  struct Reserved;
  Result<Reserved> find_or_reserve(const SessionWish& wish, const Caller& caller);
  Result<Held> reserve(SessionRecord record, const Caller& caller);  // needs the map's lock
  struct SurfaceCopy;
  Result<SurfaceCopy> copy_surface(const std::string& reference, const Caller& caller,
                                   const Progress& progress);
  Status make(SessionEntry& entry, const Caller& caller, const Progress& progress);
  void give_up(SessionEntry& entry);

  Result<std::shared_ptr<SessionEntry>> read_entry(const SessionRecord& record);

  struct Coming;
  Status bring_back(SessionEntry& entry, const Caller& caller, const Progress& progress);
  Status charge(SessionEntry& entry, const Caller& caller, Quota::Share& by_user);
  Status open_solver(SessionEntry& entry, Coming& coming, const Progress& progress);
  Status replay(const std::string& id, Coming& coming);
  void bring_back_later(const std::shared_ptr<SessionEntry>& entry,
                        const std::function<void(const Status&)>& came_back);
  Status catch_up(SessionEntry& entry, const Progress& progress);
  Result<ApplyOutcome> submit_held(const std::shared_ptr<SessionEntry>& held, const Caller& caller,
                                   std::span<const Edit> edits, OnDisk on_disk);
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
  KeptShares shares_;
  const std::shared_ptr<ListenerSlot> listener_ = std::make_shared<ListenerSlot>();
  std::atomic<bool> ending_{false};
  std::function<Status()> may_hold_;
  std::atomic<bool> has_let_go_{false};  // since may_hold_ fails

  mutable std::mutex mutex_;  // the maps; not held while a session works or a disk writes
  std::map<std::string, std::shared_ptr<SessionEntry>> sessions_;  // by id
  std::map<std::string, std::shared_ptr<SessionEntry>> by_name_;
  std::set<std::string> scans_going_;  // scans that are being deleted

  Executor background_{1};  // last member: its thread ends before the others are destroyed
};

}  // namespace burnish

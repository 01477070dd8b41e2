#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/service/session_info.h"
#include "server/session/export_file.h"
#include "server/session/journal.h"
#include "server/session/mesh_store.h"
#include "server/session/session.h"

namespace burnish {

struct SessionManagerOptions {
  size_t sessions_max = 64;
  uint64_t sessions_per_user = 1'000'000;  ///< in memory
  SolverOptions solver;
};

/// All sessions by name and id. The journal knows every session; those in use are in memory as
/// well, and come back there by replay. Thread-safe: one lock per session, held while it works.
class SessionManager {
 public:
  /// Lists the journal's sessions. Needs: folder, store and journal outlive the manager.
  static Result<std::unique_ptr<SessionManager>> create(const DataFolder& folder, MeshStore& store,
                                                        Journal& journal,
                                                        const SessionManagerOptions& options);
  ~SessionManager();

  /// Opens, or attaches to the session of that name when it is over the same prepared mesh.
  /// Fails: not_found, already_exists (the name is another's), resource_exhausted, cancelled.
  Result<OpenedSession> open(const SessionWish& wish, const Progress& progress);

  /// By name.
  std::vector<SessionInfo> list() const;

  /// What the sessions in memory take, by the admission's prediction.
  struct Usage {
    size_t in_memory = 0;
    uint64_t session_bytes = 0;
  };
  Usage usage() const;

  /// Gives the memory back; the next use brings the session back.
  Status close(const std::string& reference, const Progress& progress);

  /// Forgets the session and its edits.
  Status remove(const std::string& reference, const Progress& progress);

  /// Applies all new edits or none. When it returns they are on disk. Ids seen before are skipped.
  Result<ApplyOutcome> apply(const std::string& reference, std::span<const Edit> edits,
                             const Progress& progress);

  Result<SessionState> state(const std::string& reference, const Progress& progress);

  /// Solves and writes the edited mesh to a staging file.
  Result<std::unique_ptr<ExportFile>> export_mesh(const std::string& reference,
                                                  const ExportWish& wish, const Progress& progress);

  /// Deletes a scan of the store. Fails: failed_precondition naming a session that edits it.
  Result<std::string> delete_scan(const std::string& reference);

 private:
  struct Entry;
  /// A session's entry with its lock held and the session in memory.
  struct Held;

  SessionManager(const DataFolder& folder, MeshStore& store, Journal& journal,
                 const SessionManagerOptions& options)
      : folder_(folder),
        store_(store),
        journal_(journal),
        options_(options),
        by_user_("sessions open", "limits.sessions_per_user", options.sessions_per_user) {}

  std::shared_ptr<Entry> find(const std::string& reference) const;
  Result<std::shared_ptr<Entry>> find_or_create(const SessionWish& wish, bool& created);
  Result<Held> lock(const std::string& reference, const Progress& progress) const;
  Result<Held> use(const std::string& reference, const Progress& progress);
  Status bring_back(Entry& entry, const Progress& progress);
  Status bring_back_for(Entry& entry, const std::string& user, const Progress& progress);
  Result<ExportSummary> solve_to_file(Held& held, const ExportWish& wish,
                                      const std::filesystem::path& path, const Progress& progress);

  const DataFolder& folder_;
  MeshStore& store_;
  Journal& journal_;
  const SessionManagerOptions options_;
  Quota by_user_;

  mutable std::mutex mutex_;  // of the map; never held while a session works
  std::map<std::string, std::shared_ptr<Entry>> sessions_;  // by name
};

}  // namespace burnish

#include "server/session/session_manager.h"

#include <atomic>
#include <chrono>
#include <unordered_set>

#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"
#include "server/session/cancellable_lock.h"
#include "server/session/memory_need.h"

namespace burnish {

struct SessionManager::Entry {
  explicit Entry(SessionRecord session_record) : record(std::move(session_record)) {}

  SessionInfo info() const {
    return {record.id, record.name, record.scan_id, record.key, record.created_unix_seconds,
            edits,     in_memory};
  }

  void leave_memory() {
    session.reset();
    mesh.reset();
    memory = {};
    by_user = {};
    session_bytes = 0;
    edit_ids.clear();
    last = {};
    in_memory = false;
  }

  const SessionRecord record;
  std::atomic<uint64_t> edits{0};
  std::atomic<bool> in_memory{false};
  std::atomic<uint64_t> session_bytes{0};

  std::timed_mutex mutex;  // of what follows
  bool deleted = false;
  std::shared_ptr<const SharedMesh> mesh;
  Quota::Share memory;                       // what the session takes of the server's
  Quota::Share by_user;                      // of whoever opened it
  std::unique_ptr<Session> session;          // null: not in memory
  std::unordered_set<std::string> edit_ids;  // of the session in memory
  StepReport last;
};

struct SessionManager::Held {
  std::shared_ptr<Entry> entry;
  std::unique_lock<std::timed_mutex> lock;
};

namespace {

int64_t unix_seconds_now() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string describe(const PreparedKey& key) {
  return "depth " + std::to_string(key.depth);
}

}  // namespace

SessionManager::~SessionManager() = default;

Result<std::unique_ptr<SessionManager>> SessionManager::create(
    const DataFolder& folder, MeshStore& store, Journal& journal,
    const SessionManagerOptions& options) {
  std::unique_ptr<SessionManager> manager(new SessionManager(folder, store, journal, options));
  ASSIGN_OR_RETURN(const auto records, journal.sessions());
  for (const SessionRecord& record : records) {
    auto entry = std::make_shared<Entry>(record);
    ASSIGN_OR_RETURN(entry->edits, journal.edit_count(record.id));
    manager->sessions_[record.name] = std::move(entry);
  }
  return manager;
}

std::shared_ptr<SessionManager::Entry> SessionManager::find(const std::string& reference) const {
  const std::lock_guard lock(mutex_);
  const auto named = sessions_.find(reference);
  if (named != sessions_.end()) return named->second;
  for (const auto& [name, entry] : sessions_)
    if (entry->record.id == reference) return entry;
  return nullptr;
}

Result<SessionManager::Held> SessionManager::lock(const std::string& reference,
                                                  const Progress& progress) const {
  Held held{find(reference), {}};
  if (held.entry) {
    ASSIGN_OR_RETURN(held.lock,
                     lock_or_cancel(held.entry->mutex, "waiting for the session", progress));
  }
  if (!held.entry || held.entry->deleted)
    return not_found("no session has the name or id '" + reference + "'");
  return held;
}

Result<SessionManager::Held> SessionManager::use(const std::string& reference,
                                                 const Progress& progress) {
  ASSIGN_OR_RETURN(Held held, lock(reference, progress));
  RETURN_IF_ERROR(
      bring_back(*held.entry, progress).with_context("session " + held.entry->record.name));
  return held;
}

Status SessionManager::bring_back(Entry& entry, const Progress& progress) {
  if (entry.session) return Status::ok();
  const SessionRecord& record = entry.record;
  ASSIGN_OR_RETURN(const auto mesh, store_.open_mesh(record.scan_id, record.key, progress));
  ASSIGN_OR_RETURN(Quota::Share memory,
                   store_.memory().take(kServer, predict_session_bytes(*mesh->hierarchy)));
  ASSIGN_OR_RETURN(auto session, Session::open(mesh->prepared, mesh->hierarchy, options_.solver));
  spdlog::info("session {}: backend {} ({})", record.id, session->solver().backend_name(),
               session->solver().backend_reason());
  ASSIGN_OR_RETURN(const auto edits, journal_.edits(record.id));
  std::unordered_set<std::string> ids;
  for (const Edit& edit : edits) {
    if (!report(progress, "replaying edits", double(ids.size()) / double(edits.size())))
      return cancelled("the replay was cancelled");
    RETURN_IF_ERROR(session->apply(edit).with_context("replaying edit " + edit.id));
    ids.insert(edit.id);
  }
  entry.mesh = mesh;
  entry.session_bytes = memory.amount();
  entry.memory = std::move(memory);
  entry.session = std::move(session);
  entry.edit_ids = std::move(ids);
  entry.in_memory = true;
  return Status::ok();
}

Result<std::shared_ptr<SessionManager::Entry>> SessionManager::find_or_create(
    const SessionWish& wish, bool& created) {
  const std::lock_guard lock(mutex_);
  ASSIGN_OR_RETURN(const ScanInfo scan, store_.find(wish.scan));
  SessionRecord record{random_name(), wish.name, scan.id, resolve(wish.key, scan),
                       unix_seconds_now()};
  if (record.name.empty()) record.name = "session-" + record.id.substr(0, 6);

  const auto found = sessions_.find(record.name);
  created = found == sessions_.end();
  if (!created) {
    const SessionRecord& other = found->second->record;
    if (other.scan_id == record.scan_id && other.key == record.key) return found->second;
    return already_exists("session " + record.name + " edits scan " + short_id(other.scan_id) +
                          " at " + describe(other.key) + ", not scan " + short_id(scan.id) +
                          " at " + describe(record.key));
  }
  if (sessions_.size() >= options_.sessions_max)
    return resource_exhausted("the server has " + std::to_string(sessions_.size()) +
                              " sessions, sessions_max is " +
                              std::to_string(options_.sessions_max) + "; delete one");
  RETURN_IF_ERROR(journal_.create_session(record));
  return sessions_[record.name] = std::make_shared<Entry>(record);
}

Result<OpenedSession> SessionManager::open(const SessionWish& wish, const Progress& progress) {
  bool created = false;
  ASSIGN_OR_RETURN(const auto entry, find_or_create(wish, created));
  const Status status = bring_back_for(*entry, wish.user, progress);
  if (status.is_ok()) return OpenedSession{entry->info(), !created};
  // Nobody has been told of a session that could not be opened: take it back.
  if (created) (void)remove(entry->record.id, {});
  return status;
}

// A session in memory counts for the user who opened it.
Status SessionManager::bring_back_for(Entry& entry, const std::string& user,
                                      const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(entry.record.id, progress));
  Quota::Share share;
  if (!user.empty() && entry.by_user.amount() == 0) {
    ASSIGN_OR_RETURN(share, by_user_.take("user " + user, 1));
  }
  RETURN_IF_ERROR(bring_back(entry, progress).with_context("session " + entry.record.name));
  if (share.amount() > 0) entry.by_user = std::move(share);
  return Status::ok();
}

SessionManager::Usage SessionManager::usage() const {
  const std::lock_guard lock(mutex_);
  Usage usage;
  for (const auto& [name, entry] : sessions_) {
    usage.in_memory += entry->in_memory ? 1 : 0;
    usage.session_bytes += entry->session_bytes;
  }
  return usage;
}

std::vector<SessionInfo> SessionManager::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<SessionInfo> sessions;
  for (const auto& [name, entry] : sessions_) sessions.push_back(entry->info());
  return sessions;
}

Status SessionManager::close(const std::string& reference, const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  held.entry->leave_memory();
  return Status::ok();
}

Status SessionManager::remove(const std::string& reference, const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  RETURN_IF_ERROR(journal_.remove_session(held.entry->record.id));
  held.entry->leave_memory();
  held.entry->deleted = true;
  const std::lock_guard lock(mutex_);
  sessions_.erase(held.entry->record.name);
  return Status::ok();
}

Result<ApplyOutcome> SessionManager::apply(const std::string& reference,
                                           std::span<const Edit> edits, const Progress& progress) {
  for (const Edit& edit : edits) RETURN_IF_ERROR(validate(edit).with_context("edit " + edit.id));
  ASSIGN_OR_RETURN(const Held held, use(reference, progress));
  Entry& entry = *held.entry;

  std::vector<Edit> fresh;
  std::unordered_set<std::string> ids;
  for (const Edit& edit : edits)
    if (!entry.edit_ids.contains(edit.id) && ids.insert(edit.id).second) fresh.push_back(edit);

  Status status;
  for (size_t i = 0; i < fresh.size() && status.is_ok(); ++i)
    status = entry.session->apply(fresh[i]).with_context("edit " + fresh[i].id);
  if (status.is_ok()) status = journal_.append(entry.record.id, fresh);
  if (!status.is_ok()) {
    // The session may have seen an edit that is not in the journal: let it come back by replay.
    entry.leave_memory();
    return status;
  }
  entry.edit_ids.merge(ids);
  entry.edits += fresh.size();
  return ApplyOutcome{static_cast<uint32_t>(fresh.size()),
                      static_cast<uint32_t>(edits.size() - fresh.size()), entry.edits};
}

Result<SessionState> SessionManager::state(const std::string& reference, const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(reference, progress));
  const Entry& entry = *held.entry;
  const Fields& fields = entry.session->fields();
  const Solver& solver = entry.session->solver();
  return SessionState{
      entry.info(),        fields.gradient_scale(), fields.transfer_curve(),
      entry.last.cycle,    entry.last.energy,       entry.last.residual,
      entry.last.distance, solver.byte_count(),     std::string(solver.backend_name())};
}

Result<ExportSummary> SessionManager::solve_to_file(Held& held, const ExportWish& wish,
                                                    const std::filesystem::path& path,
                                                    const Progress& progress) {
  Entry& entry = *held.entry;
  ASSIGN_OR_RETURN(const SolveReport solved,
                   entry.session->solve({wish.exact, wish.cycles}, progress));
  entry.last = solved.last;
  metrics().observe(Measure::kAssembleSeconds, solved.assemble_seconds);
  metrics().observe(Measure::kSolveSeconds, solved.solve_seconds);
  metrics().observe(Measure::kResidual, solved.last.residual);
  const TriangleMesh mesh = entry.session->surface();
  held.lock.unlock();

  if (!report(progress, "writing", 0)) return cancelled("the export was cancelled");
  RETURN_IF_ERROR(write_mesh(mesh, path));
  ExportSummary summary;
  summary.vertices = mesh.vertices.size();
  summary.triangles = mesh.triangles.size();
  summary.cycles = solved.cycles;
  summary.converged = solved.converged;
  summary.energy = solved.last.energy;
  summary.residual = solved.last.residual;
  summary.distance = solved.last.distance;
  summary.assemble_seconds = solved.assemble_seconds;
  summary.solve_seconds = solved.solve_seconds;
  return summary;
}

Result<std::unique_ptr<ExportFile>> SessionManager::export_mesh(const std::string& reference,
                                                                const ExportWish& wish,
                                                                const Progress& progress) {
  ASSIGN_OR_RETURN(Held held, use(reference, progress));
  const auto path = folder_.staging_path("." + std::string(mesh_format_name(wish.format)));
  ASSIGN_OR_RETURN(ExportSummary summary, solve_to_file(held, wish, path, progress));
  return ExportFile::adopt(path, std::move(summary));
}

Result<std::string> SessionManager::delete_scan(const std::string& reference) {
  const std::lock_guard lock(mutex_);  // no session can be opened over the scan meanwhile
  ASSIGN_OR_RETURN(const ScanInfo scan, store_.find(reference));
  for (const auto& [name, entry] : sessions_)
    if (entry->record.scan_id == scan.id)
      return failed_precondition("scan " + scan.name + " is edited by session " + name +
                                 "; delete that first");
  RETURN_IF_ERROR(store_.remove(scan.id));
  return scan.id;
}

}  // namespace burnish

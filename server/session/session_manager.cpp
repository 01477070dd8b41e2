#include "server/session/session_manager.h"

#include <algorithm>
#include <chrono>

#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"
#include "server/session/memory_need.h"
#include "server/session/session_held.h"

namespace burnish {

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

SessionManager::~SessionManager() {
  store_.set_wanted(nullptr);
}

Result<std::unique_ptr<SessionManager>> SessionManager::create(
    const DataFolder& folder, MeshStore& store, Journal& journal,
    const SessionManagerOptions& options) {
  std::unique_ptr<SessionManager> manager(new SessionManager(folder, store, journal, options));
  ASSIGN_OR_RETURN(const auto records, journal.sessions());
  for (const SessionRecord& record : records) {
    auto entry = std::make_shared<SessionEntry>(record);
    ASSIGN_OR_RETURN(entry->edits, journal.edit_count(record.id));
    ASSIGN_OR_RETURN(entry->roles, journal.roles(record.id));
    manager->sessions_[record.name] = std::move(entry);
  }
  store.set_wanted([&manager = *manager](const std::string& scan_id, const PreparedKey& key) {
    return manager.is_edited(scan_id, key);
  });
  return manager;
}

bool SessionManager::is_edited(const std::string& scan_id, const PreparedKey& key) const {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(sessions_, [&](const auto& session) {
    const SessionRecord& record = session.second->record;
    return record.scan_id == scan_id && record.key == key;
  });
}

std::shared_ptr<SessionEntry> SessionManager::find(const std::string& reference) const {
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
  held.entry->last_use = std::chrono::steady_clock::now();
  return held;
}

Result<SessionManager::Held> SessionManager::use(const std::string& reference,
                                                 const Progress& progress) {
  ASSIGN_OR_RETURN(Held held, lock(reference, progress));
  RETURN_IF_ERROR(
      bring_back(*held.entry, progress).with_context("session " + held.entry->record.name));
  return held;
}

Status SessionManager::bring_back(SessionEntry& entry, const Progress& progress) {
  if (entry.ahead_of_journal.exchange(false)) entry.leave_memory();
  if (entry.session) return Status::ok();
  const SessionRecord& record = entry.record;
  ASSIGN_OR_RETURN(const auto mesh, store_.open_mesh(record.scan_id, record.key, progress));
  ASSIGN_OR_RETURN(const auto edits, journal_.edits(record.id));
  uint64_t bytes = predict_session_bytes(*mesh->hierarchy);
  for (const AuthoredEdit& edit : edits) bytes += bytes_in_history(edit);
  ASSIGN_OR_RETURN(Quota::Share memory, store_.memory().take(kServer, bytes));
  ASSIGN_OR_RETURN(auto session, Session::open(mesh->prepared, mesh->hierarchy, options_.solver));
  spdlog::info("session {}: backend {} ({})", record.id, session->solver().backend_name(),
               session->solver().backend_reason());
  ASSIGN_OR_RETURN(auto kept, journal_.paint(record.id, mesh->prepared->cells.size()));
  for (PaintCheckpoint& paint : kept) session->edited().offer(std::move(paint));
  RETURN_IF_ERROR(session->edited().apply(edits, progress).status().with_context("replay"));
  entry.mesh = mesh;
  entry.session_bytes = memory.amount();
  entry.memory = std::move(memory);
  entry.session = std::move(session);
  entry.edits = edits.size();
  ++entry.life;
  entry.in_memory = true;
  keep_paint(entry);
  return Status::ok();
}

void SessionManager::keep_paint(SessionEntry& entry) {
  for (const PaintCheckpoint& paint : entry.session->edited().take_kept())
    journal_.keep_paint(entry.record.id, paint);
}

Status SessionManager::check_room() const {
  if (sessions_.size() < options_.sessions_max) return Status::ok();
  return resource_exhausted("the server has " + std::to_string(sessions_.size()) +
                            " sessions, sessions_max is " + std::to_string(options_.sessions_max) +
                            "; delete one");
}

Result<std::shared_ptr<SessionEntry>> SessionManager::find_or_create(const SessionWish& wish,
                                                                     const std::string& user,
                                                                     bool& created) {
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
  RETURN_IF_ERROR(check_room());
  auto entry = std::make_shared<SessionEntry>(record);
  entry->roles = SessionRoles::of_new_session(user);
  RETURN_IF_ERROR(journal_.create_session(record, entry->roles));
  return sessions_[record.name] = std::move(entry);
}

Result<OpenedSession> SessionManager::open(const SessionWish& wish, const std::string& user,
                                           const Progress& progress) {
  bool created = false;
  ASSIGN_OR_RETURN(const auto entry, find_or_create(wish, user, created));
  const Status status = bring_back_for(*entry, user, progress);
  if (status.is_ok()) return OpenedSession{entry->info(), !created};
  // Nobody has been told of a session that could not be opened: take it back.
  if (created) (void)remove(entry->record.id, user, {});
  return status;
}

// A session in memory counts for the user who opened it.
Status SessionManager::bring_back_for(SessionEntry& entry, const std::string& user,
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

static Result<uint64_t> end_of_fork(const ForkWish& wish, const History& history) {
  if (!wish.checkpoint.empty()) return history.checkpoint(wish.checkpoint);
  if (wish.number <= history.size()) return wish.number == 0 ? history.size() : wish.number;
  return not_found("the session has " + std::to_string(history.size()) + " edits, none is number " +
                   std::to_string(wish.number));
}

Result<SessionInfo> SessionManager::fork(const ForkWish& wish, const std::string& user,
                                         const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(wish.source, progress));
  ASSIGN_OR_RETURN(const uint64_t edits,
                   end_of_fork(wish, held.entry->session->edited().history()));
  SessionRecord record = held.entry->record;
  record.id = random_name();
  record.name = wish.name.empty() ? record.name + "-" + record.id.substr(0, 6) : wish.name;
  record.created_unix_seconds = unix_seconds_now();
  auto entry = std::make_shared<SessionEntry>(record);
  entry->roles = SessionRoles::of_new_session(user);
  entry->edits = edits;

  const std::lock_guard lock(mutex_);
  if (sessions_.contains(record.name))
    return already_exists("a session " + record.name + " is there already");
  RETURN_IF_ERROR(check_room());
  RETURN_IF_ERROR(journal_.fork_session(held.entry->record.id, edits, record, entry->roles));
  sessions_[record.name] = entry;
  return entry->info();
}

std::vector<SessionInfo> SessionManager::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<SessionInfo> sessions;
  for (const auto& [name, entry] : sessions_) sessions.push_back(entry->info());
  return sessions;
}

static std::string named(const std::string& user) {
  return user.empty() ? "somebody without a name" : user;
}

Status SessionManager::close(const std::string& reference, const std::string& user,
                             const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  RETURN_IF_ERROR(held.entry->roles.require(user, SessionRole::kOwner, "closing the session"));
  held.entry->leave_memory();
  tell_left(*held.entry, failed_precondition("the session was closed by " + named(user)));
  return Status::ok();
}

Status SessionManager::remove(const std::string& reference, const std::string& user,
                              const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  RETURN_IF_ERROR(held.entry->roles.require(user, SessionRole::kOwner, "deleting the session"));
  RETURN_IF_ERROR(journal_.remove_session(held.entry->record.id));
  held.entry->leave_memory();
  held.entry->deleted = true;
  tell_left(*held.entry, not_found("the session was deleted by " + named(user)));
  const std::lock_guard lock(mutex_);
  sessions_.erase(held.entry->record.name);
  return Status::ok();
}

Result<SessionState> SessionManager::state(const std::string& reference, const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(reference, progress));
  const SessionEntry& entry = *held.entry;
  const Fields& fields = entry.session->fields();
  const Solver& solver = entry.session->solver();
  const uint64_t memory_bytes = entry.session->byte_count() + client_bytes(entry);
  return SessionState{entry.info(),
                      fields.gradient_scale(),
                      fields.transfer_curve(),
                      entry.last.cycle,
                      entry.last.energy,
                      entry.last.residual,
                      entry.last.distance,
                      memory_bytes,
                      std::string(solver.backend_name())};
}

Result<ExportSummary> SessionManager::solve_to_file(Held& held, const ExportWish& wish,
                                                    const std::filesystem::path& path,
                                                    const Progress& progress) {
  SessionEntry& entry = *held.entry;
  ASSIGN_OR_RETURN(const SolveReport solved,
                   entry.session->solve({wish.exact, wish.cycles}, progress));
  entry.last = solved.last;
  tell_changed(entry);
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

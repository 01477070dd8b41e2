#include "server/manager/session_manager.h"

#include <algorithm>
#include <chrono>

#include "common/transfer/content_hash.h"
#include "server/manager/session_manager_held.h"
#include "server/scheduling/cancellable_lock.h"

namespace burnish {

SessionManager::~SessionManager() {
  ending_ = true;
  store_.set_wanted(nullptr);
}

/// The first of its owners stands for a maker of whom the journal does not know.
static std::string maker_of(const SessionRecord& record, const SessionRoles& roles) {
  if (record.maker) return *record.maker;
  for (const auto& [user, role] : roles.by_user())
    if (!user.empty() && role == SessionRole::kOwner) return user;
  return {};
}

/// Reads a session of the journal that is not in memory.
Result<std::shared_ptr<SessionEntry>> SessionManager::read_entry(const SessionRecord& record) {
  auto entry = std::make_shared<SessionEntry>(record);
  ASSIGN_OR_RETURN(entry->edits, journal_.edit_count(record.id));
  ASSIGN_OR_RETURN(entry->roles, journal_.roles(record.id));
  ASSIGN_OR_RETURN(const uint64_t bytes, journal_.history_bytes(record.id));
  entry->kept = shares_.add(maker_of(record, entry->roles), bytes);
  entry->in_journal = true;
  return entry;
}

Result<std::unique_ptr<SessionManager>> SessionManager::create(
    const DataFolder& folder, MeshStore& store, Journal& journal,
    const SessionManagerOptions& options) {
  std::unique_ptr<SessionManager> manager(new SessionManager(folder, store, journal, options));
  ASSIGN_OR_RETURN(const auto records, journal.sessions());
  for (const SessionRecord& record : records) {
    ASSIGN_OR_RETURN(auto entry, manager->read_entry(record));
    manager->sessions_[record.id] = entry;
    manager->by_name_[record.name] = std::move(entry);
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

// Ids come first: an old journal may have names that look like an id.
std::shared_ptr<SessionEntry> SessionManager::find(const std::string& reference) const {
  const std::lock_guard lock(mutex_);
  for (const auto* map : {&sessions_, &by_name_}) {
    const auto found = map->find(reference);
    if (found != map->end()) return found->second;
  }
  return nullptr;
}

static Status no_such_session(const std::string& reference) {
  return not_found("no session has the name or id '" + reference + "'");
}

Result<SessionManager::Held> SessionManager::lock(std::shared_ptr<SessionEntry> entry,
                                                  const Progress& progress) const {
  Held held{std::move(entry), {}};
  ASSIGN_OR_RETURN(held.lock,
                   lock_or_cancel(held.entry->mutex, "waiting for the session", progress));
  held.entry->last_use = std::chrono::steady_clock::now();
  return held;
}

Result<SessionManager::Held> SessionManager::lock(const std::string& reference,
                                                  const Progress& progress) {
  RETURN_IF_ERROR(check_hold());
  std::shared_ptr<SessionEntry> entry = find(reference);
  if (!entry && journal_.is_shared()) {
    refresh();
    entry = find(reference);
  }
  if (!entry) return no_such_session(reference);
  ASSIGN_OR_RETURN(Held held, lock(std::move(entry), progress));
  if (held.entry->deleted) return no_such_session(reference);
  // Another server may have changed it meanwhile.
  if (held.entry->in_journal && (!held.entry->session || held.entry->ahead_of_journal))
    RETURN_IF_ERROR(hold(*held.entry));
  return held;
}

Result<SessionManager::Held> SessionManager::use(const std::string& reference, const Caller& caller,
                                                 const Progress& progress) {
  ASSIGN_OR_RETURN(Held held, lock(reference, progress));
  RETURN_IF_ERROR(
      bring_back(*held.entry, caller, progress).with_context("session " + held.entry->record.name));
  return held;
}

Status SessionManager::catch_up(SessionEntry& entry, const Progress& progress) {
  const Status status = entry.session->edited().catch_up(progress);
  keep_paint(entry);
  return status;
}

void SessionManager::keep_paint(SessionEntry& entry) {
  for (const PaintCheckpoint& paint : entry.session->edited().take_kept())
    journal_.keep_paint(entry.record.id, paint);
}

SessionManager::Usage SessionManager::usage() const {
  const std::lock_guard lock(mutex_);
  Usage usage;
  for (const auto& [id, entry] : sessions_) {
    usage.in_memory += entry->in_memory ? 1 : 0;
    usage.session_bytes += entry->session_bytes;
  }
  return usage;
}

std::vector<SessionInfo> SessionManager::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<SessionInfo> sessions;
  for (const auto& [name, entry] : by_name_)
    if (entry->in_journal && name == entry->record.name) sessions.push_back(entry->info());
  return sessions;
}

static std::string named(const Caller& caller) {
  return caller.user.empty() ? "somebody without a name" : caller.user;
}

Status SessionManager::close(const std::string& reference, const Caller& caller,
                             const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  RETURN_IF_ERROR(
      require_role(held.entry->roles, caller, SessionRole::kOwner, "closing the session"));
  held.entry->leave_memory();
  journal_.release(held.entry->record.id);
  tell_left(*held.entry, failed_precondition("the session was closed by " + named(caller)));
  return Status::ok();
}

// The session stays locked while the disk writes: others must know the outcome before they go on.
Status SessionManager::remove(const std::string& reference, const Caller& caller,
                              const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  RETURN_IF_ERROR(
      require_role(held.entry->roles, caller, SessionRole::kOwner, "deleting the session"));
  RETURN_IF_ERROR(note_loss(*held.entry, journal_.remove_session(held.entry->record.id)));
  give_up(*held.entry);
  tell_left(*held.entry, not_found("the session was deleted by " + named(caller)));
  return Status::ok();
}

// Needs: the entry is locked.
void SessionManager::give_up(SessionEntry& entry) {
  entry.leave_memory();
  entry.deleted = true;
  const std::lock_guard lock(mutex_);
  by_name_.erase(entry.record.name);
  sessions_.erase(entry.record.id);
}

Result<SessionState> SessionManager::state(const std::string& reference, const Caller& caller,
                                           const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(reference, caller, progress));
  RETURN_IF_ERROR(catch_up(*held.entry, progress));
  const SessionEntry& entry = *held.entry;
  const Solver& solver = entry.session->solver();
  const auto rims = entry.session->edited().pinned_rims();
  const uint64_t memory_bytes = entry.session->byte_count() + client_bytes(entry);
  return SessionState{entry.info(),
                      entry.session->fields().settings(),
                      entry.last.cycle,
                      entry.last.energy,
                      entry.last.residual,
                      entry.last.distance,
                      memory_bytes,
                      std::string(solver.backend_name()),
                      rims ? rims->rims : 0,
                      rims ? rims->held : 0,
                      entry.session->prepared().walls};
}

Result<std::string> SessionManager::delete_scan(const std::string& reference) {
  refresh();  // another server may have deleted the session that edits it
  const auto found = store_.find(reference);
  // A damaged scan is in no list: only its full id finds it.
  if (!found.is_ok() && !is_content_hash(reference)) return found.status();
  const std::string id = found.is_ok() ? found->id : reference;
  const std::string name = found.is_ok() ? found->name : short_id(id);
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [session, entry] : by_name_)
      if (entry->record.scan_id == id)
        return failed_precondition("session " + session + " edits scan " + name +
                                   "; delete the session first");
    // From here on no session can be opened on it.
    if (!scans_going_.insert(id).second) return not_found("scan " + name + " is being deleted");
  }
  const Status removed = store_.remove(id);
  const std::lock_guard lock(mutex_);
  scans_going_.erase(id);
  RETURN_IF_ERROR(removed);
  return id;
}

}  // namespace burnish

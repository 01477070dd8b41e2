// The part of SessionManager for a journal that several servers share.

#include <map>

#include <spdlog/spdlog.h>

#include "server/manager/session_entry.h"
#include "server/manager/session_manager.h"

namespace burnish {

/// Has this server hold the session, and reads what another one may have changed.
Status SessionManager::hold(SessionEntry& entry) {
  RETURN_IF_ERROR(journal_.hold(entry.record.id));
  if (!journal_.is_shared()) return Status::ok();
  ASSIGN_OR_RETURN(entry.roles, journal_.roles(entry.record.id));
  ++entry.roles_version;
  return Status::ok();
}

/// Passes the outcome of a change on. If the journal says that the session is not held here any
/// more, its next use takes it again, or finds out who has it.
Status SessionManager::note_loss(SessionEntry& entry, const Status& status) const {
  const bool is_lost = !status.moved_to().empty() || status.code() == StatusCode::kUnavailable;
  if (is_lost && journal_.is_shared()) entry.ahead_of_journal = true;
  return status;
}

/// Says where there is room for a session that has none here: on the server with the most free
/// memory. That one has the scan, or fetches it.
Status SessionManager::elsewhere(const SessionEntry& entry, const Status& why) {
  if (why.code() != StatusCode::kResourceExhausted || !store_.is_shared()) return why;
  const uint64_t taken = store_.memory().taken(), most = store_.memory().max();
  const auto place = journal_.roomier_server(most > taken ? most - taken : 0);
  if (!place.is_ok() || !*place) return why;
  if (entry.in_journal) journal_.release(entry.record.id);
  return Status::moved((*place)->text(),
                       why.message() + "; server " + (*place)->node + " has more room");
}

Status SessionManager::check_hold() {
  if (!may_hold_) return Status::ok();
  const Status status = may_hold_();
  const bool had_let_go = has_let_go_.exchange(!status.is_ok());
  if (status.is_ok() || had_let_go) return status;
  spdlog::warn("fleet: {}; it lets go of all sessions", status.message());
  let_go(status);
  return status;
}

using RecordsById = std::map<std::string, const SessionRecord*>;

/// Returns whether another server has deleted or renamed the session; false while this server uses
/// it.
static bool is_changed_elsewhere(const SessionEntry& entry, const RecordsById& there) {
  if (!entry.in_journal || entry.in_memory) return false;
  const auto record = there.find(entry.record.id);
  return record == there.end() || record->second->name != entry.record.name;
}

void SessionManager::refresh() {
  if (!journal_.is_shared()) return;
  const auto records = journal_.sessions();
  if (!records.is_ok()) {
    spdlog::warn("fleet: the list of sessions is old: {}", records.status().message());
    return;
  }
  RecordsById missing;
  for (const SessionRecord& record : *records) missing[record.id] = &record;
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(by_name_, [&](const auto& named) {
      const bool is_old = is_changed_elsewhere(*named.second, missing);
      if (is_old) sessions_.erase(named.second->record.id);
      return is_old;
    });
    for (const auto& [id, entry] : sessions_) missing.erase(id);
  }
  for (const auto& [id, record] : missing) {
    const auto entry = read_entry(*record);
    if (!entry.is_ok()) continue;  // the next refresh brings it
    const std::lock_guard lock(mutex_);
    if (by_name_.try_emplace(record->name, *entry).second) sessions_.try_emplace(id, *entry);
  }
}

void SessionManager::let_go(const Status& why) {
  std::vector<std::shared_ptr<SessionEntry>> gone;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, entry] : sessions_)
      if (entry->in_memory) gone.push_back(entry);
  }
  for (const auto& entry : gone) {
    entry->is_in_doubt = true;
    entry->ahead_of_journal = true;
    listener_->tell([&](SessionListener& to) { to.on_session_moved(entry->record.id, why); });
  }
}

}  // namespace burnish

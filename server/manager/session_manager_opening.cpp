// The part of SessionManager that makes sessions. A new session first takes its name, in an entry
// that stays locked; others with that name wait there. It is written down once it has opened, and
// nobody knows of it before, so giving up harms nobody.

#include <algorithm>
#include <chrono>

#include "common/base/clock.h"
#include "server/library/kept_name.h"
#include "server/manager/session_manager_held.h"

namespace burnish {

/// The result for a name: a session, or an entry to make one in.
struct SessionManager::Reserved {
  std::shared_ptr<SessionEntry> found;
  Held made;
};

namespace {

constexpr size_t kIdDigits = 16;

std::string describe(const PreparedKey& key) {
  return "depth " + std::to_string(key.depth);
}

/// Fails: invalid_argument for a name that could be the id of a session.
Status check_is_no_id(const std::string& name) {
  const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
  if (name.size() != kIdDigits || !std::ranges::all_of(name, is_digit)) return Status::ok();
  return invalid_argument("session name '" + name + "' has " + std::to_string(kIdDigits) +
                          " hexadecimal digits and looks like an id; choose another");
}

Status is_another(const SessionRecord& there, const SessionRecord& wanted) {
  return already_exists("session " + there.name + " edits scan " + short_id(there.scan_id) +
                        " at " + describe(there.key) + ", not scan " + short_id(wanted.scan_id) +
                        " at " + describe(wanted.key));
}

Result<uint64_t> end_of_fork(const ForkWish& wish, Journal& journal, const std::string& source_id) {
  if (!wish.checkpoint.empty()) return journal.checkpoint(source_id, wish.checkpoint);
  ASSIGN_OR_RETURN(const uint64_t edits, journal.edit_count(source_id));
  if (wish.number <= edits) return wish.number == 0 ? edits : wish.number;
  return not_found("the session has " + std::to_string(edits) + " edits, but no edit " +
                   std::to_string(wish.number));
}

}  // namespace

Result<SessionManager::Held> SessionManager::reserve(SessionRecord record, const Caller& caller) {
  RETURN_IF_ERROR(check_session_room(options_.kept, sessions_.size(), shares_, caller));
  RETURN_IF_ERROR(check_kept_name("the session's name", record.name));
  if (scans_going_.contains(record.scan_id))
    return not_found("scan " + short_id(record.scan_id) + " is being deleted");
  record.maker = caller.user;
  auto entry = std::make_shared<SessionEntry>(std::move(record));
  entry->roles = SessionRoles::of_new_session(caller.user);
  entry->kept = shares_.add(caller.user, 0);
  Held held{entry, std::unique_lock(entry->mutex)};  // nobody else knows it
  by_name_[entry->record.name] = entry;
  sessions_[entry->record.id] = entry;
  return held;
}

Result<SessionManager::Reserved> SessionManager::find_or_reserve(const SessionWish& wish,
                                                                 const Caller& caller) {
  ASSIGN_OR_RETURN(const ScanInfo scan, store_.find(wish.scan));
  SessionRecord record{random_name(),           wish.name,          scan.id,
                       resolve(wish.key, scan), unix_seconds_now(), kNewSessionControls};
  if (record.name.empty()) record.name = "session-" + record.id.substr(0, 6);

  const std::lock_guard lock(mutex_);
  const auto found = by_name_.find(record.name);
  if (found == by_name_.end()) {
    ASSIGN_OR_RETURN(Held made, reserve(std::move(record), caller));
    return Reserved{nullptr, std::move(made)};
  }
  const SessionRecord& there = found->second->record;
  if (there.scan_id != record.scan_id || there.key != record.key) return is_another(there, record);
  return Reserved{found->second, {}};
}

Result<OpenedSession> SessionManager::open(const SessionWish& wish, const Caller& caller,
                                           const Progress& progress) {
  RETURN_IF_ERROR(check_is_no_id(wish.name));
  RETURN_IF_ERROR(check_hold());
  refresh();
  for (;;) {
    ASSIGN_OR_RETURN(Reserved reserved, find_or_reserve(wish, caller));
    if (!reserved.found) {
      SessionEntry& entry = *reserved.made.entry;
      const Status made = make(entry, caller, progress);
      if (made.is_ok()) return OpenedSession{entry.info(), false};
      give_up(entry);
      return made;
    }
    ASSIGN_OR_RETURN(const Held held, lock(std::move(reserved.found), progress));
    if (held.entry->deleted) continue;  // its maker has given up: the name is free
    RETURN_IF_ERROR(bring_back(*held.entry, caller, progress)
                        .with_context("session " + held.entry->record.name));
    return OpenedSession{held.entry->info(), true};
  }
}

Status SessionManager::make(SessionEntry& entry, const Caller& caller, const Progress& progress) {
  RETURN_IF_ERROR(bring_back(entry, caller, progress).with_context("session " + entry.record.name));
  RETURN_IF_ERROR(journal_.create_session(entry.record, entry.roles));
  const Status charged =
      journal_.charge(entry.record.id, entry.opened_by, options_.sessions_per_user);
  entry.in_journal = charged.is_ok();
  if (!charged.is_ok()) (void)journal_.remove_session(entry.record.id);
  return charged;
}

Result<ForkedSession> SessionManager::fork(const ForkWish& wish, const Caller& caller,
                                           const Progress& progress) {
  RETURN_IF_ERROR(check_is_no_id(wish.name));
  SessionRecord source;
  uint64_t history_bytes = 0;
  {
    ASSIGN_OR_RETURN(const Held held, lock(wish.source, progress));
    source = held.entry->record;
    history_bytes = held.entry->kept.history_bytes();
  }
  RETURN_IF_ERROR(
      check_history_room(options_.kept, {caller.user, 0, history_bytes}, shares_, caller)
          .with_context("the fork"));
  ASSIGN_OR_RETURN(const uint64_t edits, end_of_fork(wish, journal_, source.id));
  SessionRecord record = source;
  if (wish.depth != 0) record.key.depth = wish.depth;
  if (record.key != source.key)
    RETURN_IF_ERROR(store_.prepare_scan(record.scan_id, record.key, progress, caller.user));
  record.id = random_name();
  record.name = wish.name.empty() ? record.name + "-" + record.id.substr(0, 6) : wish.name;
  record.created_unix_seconds = unix_seconds_now();

  std::unique_lock map(mutex_);
  if (by_name_.contains(record.name))
    return already_exists("session " + record.name + " already exists");
  ASSIGN_OR_RETURN(const Held made, reserve(std::move(record), caller));
  map.unlock();
  SessionEntry& entry = *made.entry;
  const Result<uint64_t> emptied = journal_.fork_session(source, edits, entry.record, entry.roles);
  if (!emptied.is_ok()) {
    give_up(entry);
    return emptied.status();
  }
  entry.edits = edits;
  entry.kept.set_history_bytes(history_bytes);
  entry.in_journal = true;
  return ForkedSession{entry.info(), *emptied};
}

// The session has both names until the disk has the new one, so that nobody takes either.
Result<SessionInfo> SessionManager::rename(const std::string& reference, const std::string& name,
                                           const Caller& caller, const Progress& progress) {
  RETURN_IF_ERROR(check_is_no_id(name));
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  SessionEntry& entry = *held.entry;
  RETURN_IF_ERROR(require_role(entry.roles, caller, SessionRole::kOwner, "renaming the session"));
  if (entry.record.name == name) return entry.info();
  RETURN_IF_ERROR(check_kept_name("the session's name", name));
  {
    const std::lock_guard map(mutex_);
    if (!by_name_.emplace(name, held.entry).second)
      return already_exists("session " + name + " already exists");
  }
  const Status renamed = note_loss(entry, journal_.rename_session(entry.record.id, name));
  const std::lock_guard map(mutex_);
  by_name_.erase(renamed.is_ok() ? entry.record.name : name);
  RETURN_IF_ERROR(renamed);
  entry.record.name = name;
  return entry.info();
}

}  // namespace burnish

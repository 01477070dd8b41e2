// The part of SessionManager for the edits and the people of one session.

#include <algorithm>
#include <chrono>
#include <future>
#include <set>
#include <string_view>

#include "common/base/clock.h"
#include "common/edit/edit_words.h"
#include "server/manager/session_manager_held.h"

namespace burnish {

/// Returns the edits that the user has not sent before, each once.
static std::vector<AuthoredEdit> new_edits(const History& history, const std::string& user,
                                           std::span<const Edit> edits) {
  std::vector<AuthoredEdit> fresh;
  std::set<std::string_view> ids;
  const int64_t now = unix_ms_now();
  for (const Edit& edit : edits)
    if (!history.knows(user, edit.id) && ids.insert(edit.id).second)
      fresh.push_back({user, now, edit});
  return fresh;
}

/// Returns `numbers` of the fresh edits, each at the place of its edit; 0 for the others.
static std::vector<uint64_t> at_their_places(std::span<const Edit> edits,
                                             const std::vector<AuthoredEdit>& fresh,
                                             const std::vector<uint64_t>& numbers) {
  std::vector<uint64_t> entries(edits.size(), 0);
  size_t next = 0;
  for (size_t i = 0; i < edits.size() && next < fresh.size(); ++i)
    if (edits[i].id == fresh[next].edit.id) entries[i] = numbers[next++];
  return entries;
}

/// Fails: failed_precondition if an edit wants to level seams of a scan without pictures.
static Status check_pictures(const Edit& edit, MeshStore& store, const std::string& scan_id) {
  const auto* texture = std::get_if<SetTexture>(&edit.change);
  if (texture == nullptr || texture->filter.level_seams == 0 || !store.shows_no_picture(scan_id))
    return Status::ok();
  return failed_precondition("the scan has no pictures whose seams could be levelled");
}

/// Edits that take others back must work in a full history.
static bool takes_back(const AuthoredEdit& edit) {
  const EditKind kind = kind_of(edit.edit);
  return kind == EditKind::kUndo || kind == EditKind::kRedo || kind == EditKind::kSwitchEntry ||
         kind == EditKind::kRestoreCheckpoint;
}

static HistoryGrowth growth_by(std::span<const AuthoredEdit> more, const SessionEntry& entry) {
  HistoryGrowth growth{entry.kept.user(), entry.session->edited().history().byte_count(), 0,
                       std::ranges::all_of(more, takes_back)};
  for (const AuthoredEdit& edit : more) growth.more += bytes_in_history(edit);
  return growth;
}

// A session's edits count as its memory.
static Status charge_for(std::span<const AuthoredEdit> more, SessionEntry& entry) {
  LayerNeed layers = entry.layers;
  layers.add(more);
  uint64_t bytes = entry.own_bytes + layers.byte_count(*entry.mesh) +
                   entry.session->edited().history().byte_count();
  for (const AuthoredEdit& edit : more) bytes += bytes_in_history(edit);
  RETURN_IF_ERROR(entry.memory.resize(bytes));
  entry.session_bytes = bytes;
  entry.layers = layers;
  return Status::ok();
}

Result<ApplyOutcome> SessionManager::submit(const std::string& reference, const Caller& caller,
                                            std::span<const Edit> edits, const Progress& progress,
                                            OnDisk on_disk) {
  ASSIGN_OR_RETURN(const Held held, use(reference, caller, progress));
  return submit_held(held.entry, caller, edits, std::move(on_disk));
}

/// Marks a session whose edits from `first` on are not on disk, or perhaps not. Returns the failure
/// for the client.
static Status fall_back(SessionEntry& entry, uint64_t first, const WriteOutcome& outcome,
                        const ListenerSlot& listener) {
  const std::string& id = entry.record.id;
  const bool is_first_doubt = outcome.is_unknown() && !entry.is_in_doubt.exchange(true);
  entry.ahead_of_journal = true;
  entry.edits = std::min<uint64_t>(entry.edits, first - 1);
  if (!entry.is_in_doubt) {
    listener.tell([&](SessionListener& to) { to.on_session_changed(id); });
    return outcome.status();
  }
  const Status why = WriteOutcome::unknown(outcome.why()).status();
  if (is_first_doubt)
    listener.tell([&](SessionListener& to) {
      const bool has_moved = !outcome.why().moved_to().empty();
      has_moved ? to.on_session_moved(id, outcome.why()) : to.on_session_lost(id, why);
    });
  return why;
}

Result<ApplyOutcome> SessionManager::submit_held(const std::shared_ptr<SessionEntry>& held,
                                                 const Caller& caller, std::span<const Edit> edits,
                                                 OnDisk on_disk) {
  for (const Edit& edit : edits) RETURN_IF_ERROR(about_edit(validate(edit), edit, edits.size()));
  SessionEntry& entry = *held;
  RETURN_IF_ERROR(require_role(entry.roles, caller, SessionRole::kEditor, "editing"));
  EditedFields& edited = entry.session->edited();

  std::vector<AuthoredEdit> fresh = new_edits(edited.history(), caller.user, edits);
  LayerCheck layers = edited.layers();
  for (const AuthoredEdit& edit : fresh) {
    Status status = layers.take(edit.edit);
    if (status.is_ok()) status = edited.check_new(edit.edit);
    if (status.is_ok()) status = check_pictures(edit.edit, store_, entry.record.scan_id);
    RETURN_IF_ERROR(about_edit(status, edit.edit, edits.size()));
  }
  RETURN_IF_ERROR(check_history_room(options_.kept, growth_by(fresh, entry), shares_, caller));
  RETURN_IF_ERROR(charge_for(fresh, entry));
  const uint64_t first = edited.history().size() + 1;
  ASSIGN_OR_RETURN(const std::vector<uint64_t> numbers, edited.record(fresh));
  const uint64_t size = edited.history().size();
  entry.kept.set_history_bytes(edited.history().byte_count());
  if (!entry.ahead_of_journal) entry.edits = size;
  ApplyOutcome outcome{static_cast<uint32_t>(fresh.size()),
                       static_cast<uint32_t>(edits.size() - fresh.size()), size,
                       at_their_places(edits, fresh, numbers)};
  const bool is_changed = !fresh.empty();
  // Also called without new edits: a known one may still be on its way to the disk. The callback
  // must not use this manager, because the journal may outlive it.
  journal_.append(
      entry.record.id, first, std::move(fresh),
      [listener = listener_, shared = held, first,
       on_disk = std::move(on_disk)](const WriteOutcome& end) {
        on_disk(end.is_on_disk() ? Status::ok() : fall_back(*shared, first, end, *listener));
      });
  if (is_changed) tell_changed(entry);
  return outcome;
}

/// Waits for the outcome of a write, or until this server has let go of the session.
static Status outcome_of(std::future<Status> written, const SessionEntry& entry) {
  static constexpr auto kLook = std::chrono::milliseconds(100);
  while (written.wait_for(kLook) != std::future_status::ready)
    if (entry.is_in_doubt)
      return unavailable(
          "the server let go of the session before the edits were on disk; send "
          "them again");
  return written.get();
}

Result<ApplyOutcome> SessionManager::apply(const std::string& reference, const Caller& caller,
                                           std::span<const Edit> edits, const Progress& progress) {
  const auto written = std::make_shared<std::promise<Status>>();
  ASSIGN_OR_RETURN(Held held, use(reference, caller, progress));
  ASSIGN_OR_RETURN(const ApplyOutcome outcome,
                   submit_held(held.entry, caller, edits,
                               [written](const Status& status) { written->set_value(status); }));
  held.lock.unlock();
  RETURN_IF_ERROR(outcome_of(written->get_future(), *held.entry));
  return outcome;
}

Result<HistoryPage> SessionManager::history(const HistoryWish& wish, const Caller& caller,
                                            const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(wish.session, caller, progress));
  const auto& entries = held.entry->session->edited().history().entries();
  auto entry = std::upper_bound(
      entries.begin(), entries.end(), wish.after,
      [](uint64_t number, const History::Entry& other) { return number < other.number; });
  HistoryPage page;
  for (; entry != entries.end() && page.entries.size() < wish.count; ++entry) {
    const AuthoredEdit& made_by = *entry->made_by;
    EditWords words = words_of(made_by.edit);
    page.entries.push_back({entry->number, made_by.edit.id, made_by.author, made_by.unix_ms,
                            kind_of(made_by.edit), summary(made_by.edit), entry->is_on(),
                            std::move(words.name), std::move(words.details), words.radius});
  }
  page.complete = entry == entries.end();
  return page;
}

Result<SessionPeople> SessionManager::people(const std::string& reference,
                                             const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, lock(reference, progress));
  return SessionPeople{held.entry->roles, held.entry->presence.list()};
}

// A role counts at once. If it cannot be written, the journal's role counts again.
Status SessionManager::set_role(const std::string& reference, const Caller& caller,
                                const std::string& subject, SessionRole role,
                                const Progress& progress) {
  ASSIGN_OR_RETURN(Held held, lock(reference, progress));
  SessionEntry& entry = *held.entry;
  const auto take = [&](SessionRoles roles) {
    entry.roles = std::move(roles);
    ++entry.roles_version;
    tell_changed(entry);
  };
  RETURN_IF_ERROR(require_role(entry.roles, caller, SessionRole::kOwner, "giving roles"));
  SessionRoles changed = entry.roles;
  RETURN_IF_ERROR(changed.set(subject, role));
  if (changed.by_user().size() > kSessionRolesMax)
    return resource_exhausted("the session has roles for " + std::to_string(kSessionRolesMax) +
                              " users, the limit is " + std::to_string(kSessionRolesMax));
  take(std::move(changed));
  held.lock.unlock();
  const Status written = note_loss(entry, journal_.set_role(entry.record.id, subject, role));
  if (written.is_ok()) return written;
  auto kept = journal_.roles(entry.record.id);
  held.lock.lock();
  if (kept.is_ok()) take(std::move(kept).value());
  return written;
}

Status SessionManager::visit(const std::string& reference, const Caller& caller,
                             const std::function<Status(Session&)>& work,
                             const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(reference, caller, progress));
  RETURN_IF_ERROR(catch_up(*held.entry, progress));
  return work(*held.entry->session);
}

Result<SeamLevelling> SessionManager::seams(const std::string& reference,
                                            const std::string& scan_id, const Caller& caller,
                                            const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(reference, caller, progress));
  const SessionRecord& record = held.entry->record;
  if (record.scan_id != scan_id)
    return invalid_argument("session " + record.name + " edits the scan " +
                            store_.name_of(record.scan_id) + ", not " + store_.name_of(scan_id));
  RETURN_IF_ERROR(catch_up(*held.entry, progress));
  return held.entry->session->seams();
}

Result<std::shared_ptr<Presence>> SessionManager::presence(const std::string& reference) const {
  const std::shared_ptr<SessionEntry> entry = find(reference);
  if (!entry) return not_found("no session has the name or id '" + reference + "'");
  return std::shared_ptr<Presence>(entry, &entry->presence);
}

}  // namespace burnish

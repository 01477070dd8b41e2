// The part of SessionManager for work on a session in turns.

#include <spdlog/spdlog.h>

#include "server/manager/session_manager_held.h"
#include "server/manager/session_turn.h"

namespace burnish {

using std::chrono::steady_clock;

void SessionManager::tell_changed(const SessionEntry& entry) const {
  listener_->tell([&](SessionListener& to) { to.on_session_changed(entry.record.id); });
}

void SessionManager::tell_left(const SessionEntry& entry, const Status& why) const {
  listener_->tell([&](SessionListener& to) { to.on_session_left(entry.record.id, why); });
}

uint64_t SessionManager::client_bytes(const SessionEntry& entry) const {
  uint64_t bytes = 0;
  listener_->tell([&](SessionListener& of) { bytes = of.client_bytes(entry.record.id); });
  return bytes;
}

Result<SessionManager::Attached> SessionManager::attach(const std::string& reference,
                                                        const Caller& caller,
                                                        const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(reference, caller, progress));
  const SessionEntry& entry = *held.entry;
  return Attached{held.entry,
                  entry.mesh,
                  entry.info(),
                  entry.roles,
                  std::string(entry.session->solver().backend_name()),
                  entry.last.cycle};
}

Result<std::optional<SessionTurn>> SessionManager::try_turn(
    const std::shared_ptr<SessionEntry>& entry, FairMutex::Ticket& ticket) {
  RETURN_IF_ERROR(check_hold());
  if (!ticket.take()) return std::optional<SessionTurn>();
  std::unique_lock lock(entry->mutex, std::adopt_lock);
  if (entry->deleted) return not_found("session " + entry->record.name + " was deleted");
  entry->last_use = steady_clock::now();
  return std::optional(SessionTurn(*this, entry, std::move(lock)));
}

void SessionManager::bring_back_later(const std::shared_ptr<SessionEntry>& entry,
                                      const std::function<void(const Status&)>& came_back) {
  const auto work = [this, entry, came_back] {
    const Progress go_on = [this](std::string_view, double) { return !ending_; };
    const auto come_back = [&]() -> Status {
      ASSIGN_OR_RETURN(const Held held, lock(entry, go_on));
      if (entry->deleted) return not_found("session " + entry->record.name + " was deleted");
      return bring_back(*entry, {}, go_on).with_context("session " + entry->record.name);
    };
    came_back(come_back());
  };
  background_.post({.work = work, .on_failure = came_back});
}

void SessionManager::spill_idle(std::chrono::seconds idle_time) {
  std::vector<std::shared_ptr<SessionEntry>> in_memory;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, entry] : sessions_)
      if (entry->in_memory) in_memory.push_back(entry);
  }
  for (const std::shared_ptr<SessionEntry>& entry : in_memory) {
    if (steady_clock::now() - entry->last_use.load() < idle_time) continue;
    // A session with people in it, or under work, is in use.
    const std::unique_lock lock(entry->mutex, std::try_to_lock);
    if (!lock.owns_lock() || !entry->session || !entry->presence.list().empty() ||
        steady_clock::now() - entry->last_use.load() < idle_time)
      continue;
    entry->leave_memory();
    journal_.release(entry->record.id);
    spdlog::info("session {}: unloaded after {} s without use", entry->record.id,
                 idle_time.count());
  }
}

}  // namespace burnish

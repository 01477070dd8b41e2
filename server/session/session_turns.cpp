// What SessionManager does for whoever works at a session in turns.

#include <spdlog/spdlog.h>

#include "server/session/session_held.h"
#include "server/session/session_turn.h"

namespace burnish {

using std::chrono::steady_clock;

void SessionManager::tell_changed(const SessionEntry& entry) const {
  if (SessionListener* listener = listener_) listener->on_session_changed(entry.record.id);
}

void SessionManager::tell_left(const SessionEntry& entry, const Status& why) const {
  if (SessionListener* listener = listener_) listener->on_session_left(entry.record.id, why);
}

uint64_t SessionManager::client_bytes(const SessionEntry& entry) const {
  SessionListener* listener = listener_;
  return listener ? listener->client_bytes(entry.record.id) : 0;
}

Result<SessionManager::Attached> SessionManager::attach(const std::string& reference,
                                                        const Progress& progress) {
  ASSIGN_OR_RETURN(const Held held, use(reference, progress));
  const SessionEntry& entry = *held.entry;
  return Attached{held.entry, entry.mesh, entry.info(), entry.roles,
                  std::string(entry.session->solver().backend_name())};
}

Result<std::optional<SessionTurn>> SessionManager::try_turn(
    const std::shared_ptr<SessionEntry>& entry, std::function<void()> when_free) {
  std::unique_lock lock(entry->mutex, std::try_to_lock);
  if (!lock.owns_lock()) {
    entry->mutex.when_free(std::move(when_free));
    return std::optional<SessionTurn>();
  }
  if (entry->deleted) return not_found("session " + entry->record.name + " was deleted");
  RETURN_IF_ERROR(bring_back(*entry, {}).with_context("session " + entry->record.name));
  entry->last_use = steady_clock::now();
  return std::optional(SessionTurn(*this, entry, std::move(lock)));
}

void SessionManager::spill_idle(std::chrono::seconds idle_time) {
  std::vector<std::shared_ptr<SessionEntry>> in_memory;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [name, entry] : sessions_)
      if (entry->in_memory) in_memory.push_back(entry);
  }
  for (const std::shared_ptr<SessionEntry>& entry : in_memory) {
    if (steady_clock::now() - entry->last_use.load() < idle_time) continue;
    // Whoever is at it uses it.
    const std::unique_lock lock(entry->mutex, std::try_to_lock);
    if (!lock.owns_lock() || !entry->session || !entry->presence.list().empty() ||
        steady_clock::now() - entry->last_use.load() < idle_time)
      continue;
    entry->leave_memory();
    spdlog::info("session {}: out of memory after {} s without use", entry->record.id,
                 idle_time.count());
  }
}

}  // namespace burnish

#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <span>

#include "server/manager/session_entry.h"
#include "server/manager/session_manager.h"

namespace burnish {

/// A session for one user of it, while this lives.
class SessionTurn {
 public:
  Session& session() { return *entry_->session; }
  const Hierarchy& hierarchy() const { return *entry_->mesh->hierarchy; }
  const SessionRoles& roles() const { return entry_->roles; }
  uint64_t roles_version() const { return entry_->roles_version; }
  uint64_t edits() const { return entry_->edits; }

  /// Returns whether somebody solves and has only lent the session: edits may be submitted, nothing
  /// else may be done.
  bool is_solving() const { return entry_->solving; }

  /// If false, the session must be brought back, and nothing else may be done.
  bool is_in_memory() const {
    return is_solving() || (entry_->session && !entry_->ahead_of_journal);
  }

  /// Starts to bring the session back after this turn. Another thread calls `came_back` with the
  /// outcome.
  void bring_back_later(const std::function<void(const Status&)>& came_back) {
    manager_->bring_back_later(entry_, came_back);
  }

  /// Brings the fields up to the history until `progress` says stop. Returns false if more is to
  /// do.
  bool catch_up(const Progress& progress) { return manager_->catch_up(*entry_, progress).is_ok(); }

  /// Changes each time the session comes back to memory: all but its edits is lost then.
  uint64_t life() const { return entry_->life; }

  /// Returns the report of the session's last step; of cycle 0 before the first step.
  StepReport& last() { return entry_->last; }

  /// As SessionManager::submit().
  Result<ApplyOutcome> submit(const Caller& caller, std::span<const Edit> edits,
                              SessionManager::OnDisk on_disk) {
    return manager_->submit_held(entry_, caller, edits, std::move(on_disk));
  }

 private:
  friend class SessionManager;
  SessionTurn(SessionManager& manager, std::shared_ptr<SessionEntry> entry,
              std::unique_lock<FairMutex> lock)
      : manager_(&manager), entry_(std::move(entry)), lock_(std::move(lock)) {}

  SessionManager* manager_;
  std::shared_ptr<SessionEntry> entry_;
  std::unique_lock<FairMutex> lock_;  // destroyed first
};

}  // namespace burnish

#pragma once

#include <memory>
#include <mutex>
#include <span>

#include "server/session/session_entry.h"
#include "server/session/session_manager.h"

namespace burnish {

/// A session in memory with nobody else at it, for as long as this lives.
class SessionTurn {
 public:
  Session& session() { return *entry_->session; }
  const Hierarchy& hierarchy() const { return *entry_->mesh->hierarchy; }
  const SessionRoles& roles() const { return entry_->roles; }
  uint64_t edits() const { return entry_->edits; }

  /// Another one whenever the session has come back to memory: what is not an edit is lost then.
  uint64_t life() const { return entry_->life; }

  /// The report of the session's last step; of cycle 0 before the first.
  StepReport& last() { return entry_->last; }

  /// As SessionManager::submit().
  Result<ApplyOutcome> submit(const std::string& user, std::span<const Edit> edits,
                              GroupCommit::Done on_disk) {
    return manager_->submit_held(entry_, user, edits, {}, std::move(on_disk));
  }

 private:
  friend class SessionManager;
  SessionTurn(SessionManager& manager, std::shared_ptr<SessionEntry> entry,
              std::unique_lock<FairMutex> lock)
      : manager_(&manager), entry_(std::move(entry)), lock_(std::move(lock)) {}

  SessionManager* manager_;
  std::shared_ptr<SessionEntry> entry_;
  std::unique_lock<FairMutex> lock_;  // first to go
};

}  // namespace burnish

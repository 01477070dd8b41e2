#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "client/model/tasks/tasks.h"
#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/service/scan_sheets.h"

namespace burnish {

/// The levelling of seams that the sheets of a session depend on.
struct SeamsOfSession {
  double amount = 0;
  std::vector<uint64_t> protects;  ///< entries of the history that make the protected region
  bool operator==(const SeamsOfSession&) const = default;
};

/// Has a server describe the sheets of a session's newest seams, one call at a time. A call for
/// older seams is cancelled, as is one whose finder goes, so that nothing is baked for nobody.
/// Never waits. Used from one thread.
class SheetFinder {
 public:
  /// Runs elsewhere, and ends soon after its progress returned false.
  using Describe =
      std::function<Result<SheetsDescription>(const SeamsOfSession& seams, const Progress&)>;
  using Take = std::function<void(const Result<SheetsDescription>&)>;

  /// `take`: gets what was found, or why nothing was; not that older seams were cancelled. Needs:
  /// `tasks` outlives this.
  SheetFinder(Tasks& tasks, Describe describe, Take take)
      : tasks_(tasks), describe_(std::move(describe)), take_(std::move(take)) {}
  ~SheetFinder() {
    if (outdated_) outdated_->store(true);
  }
  SheetFinder(const SheetFinder&) = delete;
  SheetFinder& operator=(const SheetFinder&) = delete;

  /// Finds the sheets of these seams. Cancels a call for others.
  void find(const SeamsOfSession& seams);
  /// Does so if the last ones were others.
  void follow(const SeamsOfSession& seams) {
    if (seams_ && *seams_ != seams) find(seams);
  }

  bool is_finding() const { return outdated_ != nullptr; }
  /// Returns the last seams; nothing before the first.
  const std::optional<SeamsOfSession>& seams() const { return seams_; }

 private:
  void start();
  void end(const Result<SheetsDescription>& found);

  Tasks& tasks_;
  const Describe describe_;
  const Take take_;
  std::optional<SeamsOfSession> seams_;
  std::shared_ptr<std::atomic<bool>> outdated_;  // whether the call is; null: no call
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // completions may outlive us
};

}  // namespace burnish

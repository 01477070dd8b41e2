#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "common/base/heard_loop.h"
#include "common/base/status.h"

namespace burnish {

/// Is asked while a file is read or written: before each picture, with the bytes that its decoder
/// takes beside the file; and often, for 0 bytes, which fails once somebody cancels. One call at a
/// time. A failure ends the work. Null: takes what it needs, and is never cancelled.
using FileBudget = std::function<Status(uint64_t bytes)>;

/// Asks for 0 bytes. Fails: cancelled.
inline Status hear(const FileBudget& budget) {
  return budget ? budget(0) : Status::ok();
}

/// Returns a budget that refuses nothing, and hears a cancel of `progress`. Needs: the progress and
/// the phase outlive it.
inline FileBudget heard_budget(const Progress& progress, std::string_view phase) {
  return [loop = std::make_shared<LoopProgress>(progress, phase, 0, 0)](uint64_t) {
    return loop->goes_on(0) ? Status::ok() : cancelled("the work was cancelled");
  };
}

/// Counts the steps of loops over a file, and asks a budget for 0 bytes now and then.
class FileSteps {
 public:
  FileSteps() = default;  // nobody cancels
  /// Needs: `budget` outlives this.
  explicit FileSteps(const FileBudget& budget) : budget_(&budget) {}

  /// Counts a step: a word, a line, a vertex. Throws: WorkCancelled.
  void take() {
    if (--left_ == 0) ask();
  }

 private:
  void ask() {
    left_ = kHeardBlock;
    if (budget_ != nullptr && !hear(*budget_).is_ok()) leave_cancelled_work();
  }

  const FileBudget* budget_ = nullptr;
  size_t left_ = kHeardBlock;
};

}  // namespace burnish

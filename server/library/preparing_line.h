#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/scheduling/fair_mutex.h"
#include "server/scheduling/fair_mutexes.h"

namespace burnish {

/// The line of the scans that wait to be prepared. A preparation uses all cores and much memory, so
/// one runs at a time. Beside it one small scan is prepared, so that small scans pass large ones.
/// Calls for the same scan have their turns one after the other. Thread-safe.
class PreparingLine {
 public:
  /// The right to prepare a scan, while it lives. Needs: its line outlives it.
  class Turn {
   public:
    Turn(Turn&&) = default;

   private:
    friend class PreparingLine;
    Turn() = default;

    std::shared_ptr<FairMutex> scan_;
    std::unique_lock<FairMutex> scan_lock_;
    std::unique_lock<FairMutex> place_lock_;
  };

  /// Waits in line. Fails: cancelled.
  Result<Turn> wait(const std::string& scan_id, bool is_small, const Progress& progress);

 private:
  FairMutex large_, small_;
  FairMutexes<std::string> scans_;
};

}  // namespace burnish

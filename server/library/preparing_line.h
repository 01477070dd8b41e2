#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/scheduling/fair_mutex.h"
#include "server/scheduling/fair_mutexes.h"

namespace burnish {

/// The line of the scans that wait to be prepared. A preparation uses all cores and much memory, so
/// one runs at a time. Beside it one small scan is prepared, so that small scans pass large ones.
/// Who seemed small and takes long waits with the large ones before it goes on. A user has one
/// slot among the large scans and one among the small: who asks for many keeps others waiting for
/// one. Calls for the same scan have their turns one after the other. Thread-safe.
class PreparingLine {
 public:
  using Clock = std::function<std::chrono::steady_clock::time_point()>;
  /// A small scan keeps its slot for so long.
  static constexpr std::chrono::seconds kSmallMax{10};

  explicit PreparingLine(Clock clock = std::chrono::steady_clock::now) : clock_(std::move(clock)) {}

  /// The right to prepare a scan, while it lives. Needs: its line outlives it.
  class Turn {
   public:
    Turn(Turn&&) = default;

    /// Returns the progress to prepare with: it waits once a small scan has had its time. Needs:
    /// this outlives it.
    Progress progress(const Progress& told);

   private:
    friend class PreparingLine;
    explicit Turn(PreparingLine& line) : line_(&line) {}
    Status change_slots(const Progress& told);

    PreparingLine* line_;
    std::shared_ptr<FairMutex> user_, scan_;
    std::unique_lock<FairMutex> user_lock_, scan_lock_;
    std::unique_lock<FairMutex> slot_lock_;
    std::optional<std::chrono::steady_clock::time_point> end_;  ///< of a small scan's slot
  };

  struct Wish {
    std::string user;
    std::string scan_id;
    bool is_small = false;
  };
  /// Waits in line. Fails: cancelled.
  Result<Turn> wait(const Wish& wish, const Progress& progress);

 private:
  const Clock clock_;
  FairMutex large_, small_;
  // Taken in this order, one of each: users, scans, large or small.
  FairMutexes<std::pair<std::string, bool>> users_;  // by name, and whether the scan is small
  FairMutexes<std::string> scans_;
};

}  // namespace burnish

#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/model/tasks/tasks.h"
#include "client/model/tasks/whole_progress.h"
#include "common/base/progress.h"

namespace burnish {

/// Long work as users see it: its name, its progress, and a way to end it. The working thread and
/// the showing thread share it.
class Activity {
 public:
  explicit Activity(std::string title, bool makes_file = false)
      : title_(std::move(title)), makes_file_(makes_file) {}
  /// Work of several phases: the fraction is that of the whole.
  Activity(std::string title, std::vector<PlannedPhase> plan)
      : title_(std::move(title)), whole_(std::in_place, std::move(plan), Clock::now()) {}

  const std::string& title() const { return title_; }
  bool makes_file() const { return makes_file_; }  ///< which is lost if the program ends
  void cancel() { cancelled_ = true; }
  bool is_cancelled() const { return cancelled_; }

  struct State {
    std::string phase;
    double fraction = 0;                 ///< 0 to 1
    std::optional<double> seconds_left;  ///< of the whole
  };
  State state() {
    const std::lock_guard lock(mutex_);
    if (!whole_) return state_;
    return {state_.phase, whole_->fraction(Clock::now()), whole_->seconds_left(Clock::now())};
  }
  void report(std::string_view phase, double fraction) {
    const std::lock_guard lock(mutex_);
    state_ = {std::string(phase), fraction, std::nullopt};
    if (whole_) whole_->report(phase, fraction, Clock::now());
  }

 private:
  using Clock = std::chrono::steady_clock;
  const std::string title_;
  const bool makes_file_ = false;
  std::atomic<bool> cancelled_{false};
  std::mutex mutex_;  // guards the following members
  State state_;
  std::optional<WholeProgress> whole_;
};

/// Returns a Progress that reports to the activity and ends the work when either side asks for it.
inline Progress progress_of(std::shared_ptr<Activity> activity, StopToken stop) {
  return [activity = std::move(activity), stop = std::move(stop)](std::string_view phase,
                                                                  double fraction) {
    activity->report(phase, fraction);
    return !activity->is_cancelled() && !stop.stop_requested();
  };
}

}  // namespace burnish

#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

#include "common/base/progress.h"

namespace burnish {

/// Long work as users see it: its name, its progress, and a way to end it. The working thread and
/// the showing thread share it.
class Activity {
 public:
  explicit Activity(std::string title) : title_(std::move(title)) {}

  const std::string& title() const { return title_; }
  void cancel() { cancelled_ = true; }
  bool is_cancelled() const { return cancelled_; }

  struct State {
    std::string phase;
    double fraction = 0;  ///< 0 to 1
  };
  State state() const {
    const std::lock_guard lock(mutex_);
    return state_;
  }
  void set_state(State state) {
    const std::lock_guard lock(mutex_);
    state_ = std::move(state);
  }

 private:
  const std::string title_;
  std::atomic<bool> cancelled_{false};
  mutable std::mutex mutex_;
  State state_;
};

/// Returns a Progress that reports to the activity and ends the work when either side asks for it.
inline Progress progress_of(std::shared_ptr<Activity> activity, std::stop_token stop) {
  return [activity = std::move(activity), stop = std::move(stop)](std::string_view phase,
                                                                  double fraction) {
    activity->set_state({std::string(phase), fraction});
    return !activity->is_cancelled() && !stop.stop_requested();
  };
}

}  // namespace burnish

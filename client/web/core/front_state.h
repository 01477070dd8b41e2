#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "client/model/tasks/activity.h"

namespace burnish {

/// A script that a page records.
struct Script {
  std::string name;  ///< of its file
  std::string lines;
};

/// The state that a page shows besides the model's. A window keeps the same in its panels.
struct FrontState {
  std::string server;               ///< HOST:PORT of the page
  std::set<uint64_t> dismissed;     ///< numbers of messages
  bool shows_figures = true;        ///< figures of frames and link, which change all the time
  bool shows_protection = false;    ///< over the surface
  bool shows_curves = false;        ///< likewise, where the palette's curves rule
  double section_exaggeration = 1;  ///< of heights
  std::optional<Script> script;     ///< that is being recorded

  /// Returns a number for each activity, which stays.
  uint64_t number_of(const std::shared_ptr<Activity>& activity) {
    const auto [found, is_new] = activities_.try_emplace(activity, last_activity_ + 1);
    last_activity_ += is_new;
    return found->second;
  }

 private:
  std::map<std::weak_ptr<Activity>, uint64_t, std::owner_less<>> activities_;
  uint64_t last_activity_ = 0;
};

}  // namespace burnish

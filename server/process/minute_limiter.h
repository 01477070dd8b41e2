#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace burnish {

/// Admits a thing once a minute, and counts the times between. Keep the number of things small.
/// Thread-safe.
class MinuteLimiter {
 public:
  using Time = std::chrono::steady_clock::time_point;

  struct Turn {
    bool is_admitted = false;
    uint64_t left_out = 0;  ///< times since the last admitted one
  };

  Turn take(const std::string& what, Time now);

 private:
  struct Last {
    Time at;
    uint64_t left_out = 0;
  };

  std::mutex mutex_;
  std::map<std::string, Last> last_;
};

}  // namespace burnish

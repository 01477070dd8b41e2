#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "common/base/status.h"

namespace burnish {

/// Asks again and again, on a thread of its own, whether the solver's device works. Its first
/// failure stays: a device that has failed once gives wrong results or none.
class DeviceWatch {
 public:
  struct Times {
    std::chrono::milliseconds between_probes{250};
    std::chrono::milliseconds answer_max{5000};  ///< a probe that takes longer has failed
  };

  /// `probe` should take a millisecond or so.
  DeviceWatch(std::function<Status()> probe, Times times);
  explicit DeviceWatch(std::function<Status()> probe) : DeviceWatch(std::move(probe), Times{}) {}

  /// Waits for a probe that is under way.
  ~DeviceWatch();

  Status status() const;

 private:
  void run();

  const std::function<Status()> probe_;
  const Times times_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  Status status_;
  std::chrono::steady_clock::time_point answered_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace burnish

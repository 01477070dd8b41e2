#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "common/base/clock.h"
#include "common/base/status.h"

namespace burnish {

/// Asks again and again, on a thread of its own, whether the solver's device works. Its first
/// failure stays: a device that has failed once gives wrong results or none.
class DeviceWatch {
 public:
  struct Times {
    /// With 0 nothing is asked but by ask_once(), for tests.
    std::chrono::milliseconds between_probes{250};
    std::chrono::milliseconds answer_max{5000};  ///< a probe that takes longer has failed
  };

  /// `probe` should take a millisecond or so.
  DeviceWatch(std::function<Status()> probe, Times times,
              Clock clock = std::chrono::steady_clock::now);
  explicit DeviceWatch(std::function<Status()> probe) : DeviceWatch(std::move(probe), Times{}) {}

  /// Waits for a probe that is under way.
  ~DeviceWatch();

  Status status() const;

  /// Asks, unless the device has failed already. Returns whether it works.
  bool ask_once();

 private:
  void run();
  bool wait_for_next();

  const std::function<Status()> probe_;
  const Times times_;
  const Clock clock_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  Status status_;
  std::chrono::steady_clock::time_point answered_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace burnish

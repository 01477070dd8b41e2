#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "common/base/clock.h"
#include "common/base/status.h"

namespace burnish {

/// Probes the solver's device on its own thread, again and again. The first failure stays: a device
/// that has failed once gives wrong results or none.
class DeviceWatch {
 public:
  struct Times {
    /// At 0 only ask_once() probes, for tests.
    std::chrono::milliseconds between_probes{250};
    std::chrono::milliseconds answer_max{5000};  ///< a slower probe counts as failed
  };

  /// `probe` should take a millisecond or so.
  DeviceWatch(std::function<Status()> probe, Times times,
              Clock clock = std::chrono::steady_clock::now);
  explicit DeviceWatch(std::function<Status()> probe) : DeviceWatch(std::move(probe), Times{}) {}

  /// Waits for a running probe.
  ~DeviceWatch();

  Status status() const;

  /// Probes, unless the device has failed already. Returns whether it works.
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

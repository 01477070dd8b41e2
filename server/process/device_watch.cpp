#include "server/process/device_watch.h"

namespace burnish {

DeviceWatch::DeviceWatch(std::function<Status()> probe, Times times, Clock clock)
    : probe_(std::move(probe)), times_(times), clock_(std::move(clock)), answered_(clock_()) {
  if (times_.between_probes.count() > 0) thread_ = std::thread([this] { run(); });
}

DeviceWatch::~DeviceWatch() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void DeviceWatch::run() {
  while (ask_once() && wait_for_next()) {
  }
}

bool DeviceWatch::ask_once() {
  std::unique_lock lock(mutex_);
  if (!status_.is_ok()) return false;
  lock.unlock();
  const Status answer = probe_();
  lock.lock();
  status_ = answer;
  answered_ = clock_();
  return status_.is_ok();
}

// Returns whether there is a next probe.
bool DeviceWatch::wait_for_next() {
  std::unique_lock lock(mutex_);
  return !wake_.wait_for(lock, times_.between_probes, [this] { return ending_; });
}

Status DeviceWatch::status() const {
  const std::lock_guard lock(mutex_);
  if (!status_.is_ok()) return status_;
  const auto silent = std::chrono::duration_cast<std::chrono::milliseconds>(clock_() - answered_ -
                                                                            times_.between_probes);
  if (silent <= times_.answer_max) return Status::ok();
  return internal_error("the device has not answered for " + std::to_string(silent.count()) +
                        " ms, the limit is " + std::to_string(times_.answer_max.count()));
}

}  // namespace burnish

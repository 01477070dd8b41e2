#include "server/process/device_watch.h"

namespace burnish {

using std::chrono::steady_clock;

DeviceWatch::DeviceWatch(std::function<Status()> probe, Times times)
    : probe_(std::move(probe)), times_(times), answered_(steady_clock::now()) {
  thread_ = std::thread([this] { run(); });
}

DeviceWatch::~DeviceWatch() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void DeviceWatch::run() {
  std::unique_lock lock(mutex_);
  while (!ending_ && status_.is_ok()) {
    lock.unlock();
    const Status answer = probe_();
    lock.lock();
    status_ = answer;
    answered_ = steady_clock::now();
    wake_.wait_for(lock, times_.between_probes, [this] { return ending_; });
  }
}

Status DeviceWatch::status() const {
  const std::lock_guard lock(mutex_);
  if (!status_.is_ok()) return status_;
  const auto silent = std::chrono::duration_cast<std::chrono::milliseconds>(
      steady_clock::now() - answered_ - times_.between_probes);
  if (silent <= times_.answer_max) return Status::ok();
  return internal_error("the device has not answered for " + std::to_string(silent.count()) +
                        " ms, the limit is " + std::to_string(times_.answer_max.count()));
}

}  // namespace burnish

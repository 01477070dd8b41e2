#pragma once

#include <cuda_runtime_api.h>

#include "common/base/status.h"

namespace burnish::cuda {

/// Makes the Status of a failed CUDA call: `what` and CUDA's own words.
Status cuda_status(cudaError_t error, const char* what);

/// One backend's queue of work on a device, and its first failure. After a failure it queues
/// nothing more: CUDA's errors stay, and later results would be of no use.
class Stream {
 public:
  static constexpr int kAsItSuits = -1;

  /// Kernels of a more urgent stream run before others, also in a graph.
  enum class Urgency { kFirst, kBeside };
  explicit Stream(int device, Urgency urgency = Urgency::kFirst);
  ~Stream();
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// For calls of CUDA: makes the stream's device the thread's device.
  cudaStream_t get() const {
    use_device();
    return stream_;
  }
  int device() const { return device_; }
  bool is_ok() const { return status_.is_ok(); }
  /// Returns whether the device can start a kernel while the previous one still runs (from sm_90
  /// on).
  bool starts_early() const { return starts_early_; }
  const Status& status() const { return status_; }

  /// Sets the percentage of a multiprocessor's memory that kernels get as shared memory; the rest
  /// is first-level cache. By default each kernel gets its own best value. A multiprocessor must
  /// run empty to change it, and next to other kernels hardly any cache may be left.
  void share_memory(int percent) { shared_percent_ = percent; }
  int shared_percent() const { return shared_percent_; }

  /// Keeps the first failure. Returns is_ok().
  bool check(cudaError_t error, const char* what);
  bool check(const Status& status);
  /// Waits for the device. Work may fail only here.
  bool synchronize();

 private:
  void use_device() const;

  int device_;
  cudaStream_t stream_ = nullptr;
  bool starts_early_ = false;
  int shared_percent_ = kAsItSuits;
  Status status_;
};

}  // namespace burnish::cuda

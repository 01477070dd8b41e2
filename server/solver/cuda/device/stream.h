#pragma once

#include <cuda_runtime_api.h>

#include "common/base/status.h"

namespace burnish::cuda {

/// A failed CUDA call as a Status: `what` and CUDA's own words.
Status cuda_status(cudaError_t error, const char* what);

/// One backend's queue of work on a device, and its first failure. Once a call has failed nothing
/// more is queued: CUDA's errors stick, and later results would be of no use.
class Stream {
 public:
  static constexpr int kAsItSuits = -1;

  /// Kernels of a more urgent stream go before others, also in a graph.
  enum class Urgency { kFirst, kBeside };
  explicit Stream(int device, Urgency urgency = Urgency::kFirst);
  ~Stream();
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// For a call of CUDA, which then finds the stream's device to be the thread's.
  cudaStream_t get() const {
    use_device();
    return stream_;
  }
  int device() const { return device_; }
  bool is_ok() const { return status_.is_ok(); }
  /// Whether the device can bring a kernel up while the one before still runs (from sm_90 on).
  bool starts_early() const { return starts_early_; }
  const Status& status() const { return status_; }

  /// How much of a multiprocessor's memory kernels find as shared memory, in percent; the rest is
  /// first-level cache. As it is, each kernel has what suits it alone, for which a multiprocessor
  /// must run empty: beside others it may find hardly any cache left.
  void share_memory(int percent) { shared_percent_ = percent; }
  int shared_percent() const { return shared_percent_; }

  /// Keeps a failure if it is the first. Returns is_ok().
  bool check(cudaError_t error, const char* what);
  bool check(const Status& status);
  /// Waits for the device, which may fail only now.
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

#pragma once

#include "server/solver/cuda/device/stream.h"

namespace burnish::cuda {

/// Work beside a stream's own, which goes before it: it may run at the same time as what the stream
/// is given between fork() and join(). Recorded in a graph it becomes a branch of it.
class Branch {
 public:
  explicit Branch(Stream& trunk);
  ~Branch();
  Branch(const Branch&) = delete;
  Branch& operator=(const Branch&) = delete;

  /// What follows here comes after all that the trunk has been given so far, and shares memory as
  /// the trunk does.
  void fork();
  Stream& stream() { return stream_; }
  /// What follows in the trunk comes after all that was given here; failures are the trunk's.
  void join();

 private:
  Stream& trunk_;
  Stream stream_;
  cudaEvent_t forked_ = nullptr, joined_ = nullptr;
};

}  // namespace burnish::cuda

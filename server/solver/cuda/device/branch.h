#pragma once

#include "server/solver/cuda/device/stream.h"

namespace burnish::cuda {

/// Work next to a stream's own work, which has priority. It may run at the same time as the
/// stream's work between fork() and join(). Recorded in a graph it becomes a branch of the graph.
class Branch {
 public:
  explicit Branch(Stream& trunk);
  ~Branch();
  Branch(const Branch&) = delete;
  Branch& operator=(const Branch&) = delete;

  /// Later work of the branch comes after all earlier work of the trunk. The branch shares memory
  /// as the trunk does.
  void fork();
  Stream& stream() { return stream_; }
  /// Later work of the trunk comes after all work of the branch. The trunk takes over its failures.
  void join();

 private:
  Stream& trunk_;
  Stream stream_;
  cudaEvent_t forked_ = nullptr, joined_ = nullptr;
};

}  // namespace burnish::cuda

#pragma once

#include <functional>
#include <map>

#include "server/solver/cuda/device/stream.h"

namespace burnish::cuda {

/// Recorded sequences of work, each started as one: a launch costs more than most kernels take.
class Graphs {
 public:
  explicit Graphs(Stream& stream) : stream_(stream) {}
  ~Graphs();
  Graphs(const Graphs&) = delete;
  Graphs& operator=(const Graphs&) = delete;

  /// Does `work`, which queues the same kernels whenever `key` is the same. It runs as it is the
  /// first time (kernels are loaded then), is recorded the second time and replayed from then on.
  void run(int key, const std::function<void()>& work);

 private:
  cudaGraphExec_t record(const std::function<void()>& work);

  Stream& stream_;
  std::map<int, cudaGraphExec_t> graphs_;  // null after the first time
};

}  // namespace burnish::cuda

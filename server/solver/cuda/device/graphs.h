#pragma once

#include <functional>
#include <map>

#include "server/solver/cuda/device/stream.h"

namespace burnish::cuda {

/// Recorded sequences of work. Each starts as one: a launch costs more than most kernels take.
class Graphs {
 public:
  explicit Graphs(Stream& stream) : stream_(stream) {}
  ~Graphs();
  Graphs(const Graphs&) = delete;
  Graphs& operator=(const Graphs&) = delete;

  /// Does `work`. Needs: `work` queues the same kernels for the same `key`. The first time it just
  /// runs, which loads the kernels. The second time it is recorded; later times replay it.
  void run(int key, const std::function<void()>& work);

 private:
  cudaGraphExec_t record(const std::function<void()>& work);

  Stream& stream_;
  std::map<int, cudaGraphExec_t> graphs_;  // null after the first time
};

}  // namespace burnish::cuda

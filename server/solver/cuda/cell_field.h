#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "server/solver/cuda/device_memory.h"

namespace burnish::cuda {

/// Floats per cell, kCount of them one after the other, in memory of the host that kernels read
/// themselves: what they do with the first cells hides how long the last take to come.
template <int kCount>
class CellFields {
 public:
  CellFields(Stream& stream, size_t cells) : cells_(cells), host_(stream, kCount * cells) {}

  /// Needs: no kernel that reads them is under way.
  void set(const std::array<std::span<const float>, kCount>& values) {
    constexpr size_t kChunk = 1024;
#pragma omp parallel for schedule(static)
    for (size_t first = 0; first < host_.size() / kCount; first += kChunk)
      for (int n = 0; n < kCount; ++n)
        std::copy_n(&values[n][first], std::min(kChunk, cells_ - first),
                    host_.data() + n * cells_ + first);
  }

  const float* data(int n = 0) const {
    return host_.data() + n * cells_;
  }

 private:
  size_t cells_;
  PinnedArray<float> host_;
};

}  // namespace burnish::cuda

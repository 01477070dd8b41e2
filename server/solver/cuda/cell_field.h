#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/uniform.h"

namespace burnish::cuda {

/// Floats per cell, kCount of them one after the other, in memory of the host that kernels read
/// themselves: what they do with the first cells hides how long the last take to come.
template <int kCount>
class CellFields {
 public:
  CellFields(Stream& stream, size_t cells) : cells_(cells), host_(stream, kCount * cells) {}

  /// Needs: no kernel that reads them is under way.
  void set(const std::array<std::span<const float>, kCount>& values) {
    const auto chunks = static_cast<int64_t>(host_.size() / kCount + kChunk - 1) / kChunk;
#pragma omp parallel for schedule(static)
    for (int64_t chunk = 0; chunk < chunks; ++chunk)
      for (int n = 0; n < kCount; ++n)
        std::ranges::copy(chunk_of(values[n], chunk), host_.data() + n * cells_ + chunk * kChunk);
  }

  const float* data(int n = 0) const {
    return host_.data() + n * cells_;
  }

 private:
  size_t cells_;
  PinnedArray<float> host_;
};

}  // namespace burnish::cuda

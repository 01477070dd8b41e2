#pragma once

#include <array>
#include <span>

#include "server/solver/cuda/device_memory.h"

namespace burnish::cuda {

/// Floats per cell on the device, kCount of them one after the other, with their place on the host
/// for copies at full speed.
template <int kCount>
class CellFields {
 public:
  CellFields(Stream& stream, size_t cells)
      : cells_(cells), device_(stream, kCount * cells), host_(stream, kCount * cells) {}

  /// Needs: the last upload is through.
  void upload(Stream& stream, const std::array<std::span<const float>, kCount>& values) {
    if (!stream.is_ok()) return;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < cells_; ++i)
      for (int n = 0; n < kCount; ++n) host_.data()[n * cells_ + i] = values[n][i];
    device_.upload(stream, {host_.data(), host_.size()});
  }

  const float* data(int n = 0) const {
    return device_.data() + n * cells_;
  }
  uint64_t byte_count() const {
    return device_.byte_count();
  }

 private:
  size_t cells_;
  DeviceArray<float> device_;
  PinnedArray<float> host_;
};

}  // namespace burnish::cuda

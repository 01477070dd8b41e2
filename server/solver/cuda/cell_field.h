#pragma once

#include "server/solver/cuda/device_memory.h"

namespace burnish::cuda {

/// One float per cell on the device, with its place on the host for copies at full speed.
class CellField {
 public:
  CellField(Stream& stream, size_t cells) : device_(stream, cells), host_(stream, cells) {}

  /// Needs: the last upload is through.
  void upload(Stream& stream, std::span<const float> values) {
    if (!stream.is_ok()) return;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < values.size(); ++i) host_.data()[i] = values[i];
    device_.upload(stream, {host_.data(), values.size()});
  }

  const float* data() const {
    return device_.data();
  }
  uint64_t byte_count() const {
    return device_.byte_count();
  }

 private:
  DeviceArray<float> device_;
  PinnedArray<float> host_;
};

}  // namespace burnish::cuda

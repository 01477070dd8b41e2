#pragma once

#include <cstdint>
#include <span>

#include "common/denoise/denoise.h"
#include "server/solver/cuda/denoise/filter_views.h"
#include "server/solver/cuda/device/device_memory.h"

namespace burnish::cuda {

/// A surface's places and rings on the device. Weights of pairs are 0 until set_nearness().
class DeviceSurface {
 public:
  /// Copies the surface. Throws: std::bad_alloc.
  DeviceSurface(Stream& stream, const DenoiseSurface& surface);

  void set_nearness(Stream& stream, std::span<const float> nearness);

  Rings rings() const;
  Places places() const;
  uint64_t byte_count() const;

 private:
  DeviceArray<uint64_t> ring_start_, fan_start_;
  DeviceArray<uint32_t> ring_triangle_, fans_, place_;
  DeviceArray<float> nearness_;
  DeviceArray<Corners> triangles_;
  DeviceArray<uint8_t> is_surface_;
  DeviceArray<Double3> vertices_;
  double unit_;
};

}  // namespace burnish::cuda

#pragma once

#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// Owns one session's numbers at one depth.
class DeviceDepth {
 public:
  /// With S to all digits of a float, or as it is in products alone.
  DeviceDepth(Stream& stream, const Topology& topology, bool with_rest);

  const Depth& view() const { return view_; }
  uint64_t byte_count() const;

 private:
  DeviceArray<uint32_t> packed_;
  DeviceArray<float> rest_, long_entries_, diagonal_, inverse_diagonal_;
  DeviceArray<float4> x_, f_, r_;
  Depth view_;
};

}  // namespace burnish::cuda

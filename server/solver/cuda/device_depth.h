#pragma once

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/named_bits.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Owns one session's numbers at one depth.
class DeviceDepth {
 public:
  /// The digits of S that it keeps.
  enum class Digits { kPacked, kOfAFloat, kOfADouble };
  DeviceDepth(Stream& stream, const Topology& topology, Digits digits);

  const Depth& view() const { return view_; }
  /// Appends S and its inverse diagonal.
  void read(Stream& stream, const std::string& name, std::vector<NamedBits>& to) const;
  uint64_t byte_count() const;

 private:
  DeviceArray<uint32_t> packed_;
  DeviceArray<float> rest_, remainder_, long_entries_, diagonal_, inverse_diagonal_;
  DeviceArray<float4> x_, f_, r_;
  Depth view_;
};

}  // namespace burnish::cuda

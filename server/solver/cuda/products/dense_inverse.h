#pragma once

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/read_bits.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// The explicit inverse of a small depth's matrix, scaled and regularised as in
/// cpu/products/coarsest.h, made and applied on the device.
class DenseInverse {
 public:
  static constexpr int32_t kCornersMax = 4096;  ///< at most two squares of 134 MB in double

  DenseInverse() = default;
  /// Needs: at most kCornersMax corners.
  DenseInverse(Stream& stream, const Depth& depth);

  void factor(Stream& stream);
  void solve(Stream& stream) const;  ///< x = S⁻¹ f
  uint64_t byte_count() const;
  /// Appends the inverse.
  void read(Stream& stream, std::vector<NamedBits>& to) const {
    read_bits(stream, "coarsest inverse", inverse_, to);
  }

 private:
  Depth depth_{};
  DeviceArray<double> square_[2];         // the elimination alternates between them
  DeviceArray<double> pivot_inverse_[2];  // likewise
  DeviceArray<float> inverse_;
};

}  // namespace burnish::cuda

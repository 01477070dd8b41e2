#pragma once

#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/views.h"
#include "server/solver/depth_transfer.h"

namespace burnish::cuda {

/// A depth's DepthTransfer on the device: nothing of the coarsest.
class DeviceTransfer {
 public:
  DeviceTransfer() = default;
  DeviceTransfer(Stream& stream, const DepthTransfer& transfer);

  /// Fills in what of a depth's topology is of this.
  void put_into(Topology& topology) const;
  uint64_t byte_count() const;

 private:
  DeviceArray<FromCell> prolongation_;
  DeviceArray<int64_t> restriction_start_;
  DeviceArray<uint32_t> restriction_;
  DeviceArray<int32_t> shared_, shared_start_, shared_from_, rest_start_, rest_corner_;
  DeviceArray<float> shared_weight_, rest_weight_;
};

}  // namespace burnish::cuda

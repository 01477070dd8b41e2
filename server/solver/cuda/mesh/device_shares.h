#pragma once

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cuda {

/// A coarse depth's CellShares, and the block of each target, on the device; empty if it has none.
class DeviceShares {
 public:
  DeviceShares() = default;
  /// `depth`: the coarse depth, which the shares belong to.
  DeviceShares(Stream& stream, const HierarchyDepth& depth);

  Shares view() const;
  uint64_t byte_count() const;

 private:
  DeviceArray<CellPart> part_;
  DeviceArray<CellShare> share_;
  DeviceArray<int32_t> target_, start_, block_, apart_;
};

}  // namespace burnish::cuda

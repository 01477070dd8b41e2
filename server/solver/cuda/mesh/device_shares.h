#pragma once

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/sheets/cell_shares.h"

namespace burnish::cuda {

/// A coarse depth's CellShares on the device; empty if it has none.
class DeviceShares {
 public:
  DeviceShares() = default;
  DeviceShares(Stream& stream, const CellShares& shares);

  Shares view() const;
  uint64_t byte_count() const;

 private:
  DeviceArray<CellPart> part_;
  DeviceArray<CellShare> share_;
  DeviceArray<int32_t> target_, start_, apart_;
};

}  // namespace burnish::cuda

#pragma once

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/stencil.h"

namespace burnish::cuda {

/// Returns where number `source` of a depth's cells and ties (number_of_cell(), number_of_tie())
/// stands on the device. The device has all cells' first numbers, then all cells' second; ties keep
/// their order.
inline int32_t place_of_number(int32_t source, int32_t cells) {
  const int32_t of_cells = kNumbersPerCell * cells;
  return source < of_cells ? source % kNumbersPerCell * cells + source / kNumbersPerCell : source;
}

/// A depth's irregular rows and cells on the device; empty if it has none.
class DeviceIrregular {
 public:
  DeviceIrregular() = default;
  DeviceIrregular(Stream& stream, const Stencil& stencil, int32_t cells);

  Irregular view() const;
  LongRows long_rows() const;
  uint64_t byte_count() const;

 private:
  DeviceArray<int32_t> corner_, source_, cell_, long_start_, long_column_;
  DeviceArray<int64_t> sum_start_, source_start_;
  DeviceArray<PairEntries> entry_;
};

}  // namespace burnish::cuda

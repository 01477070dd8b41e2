#pragma once

#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A target's matrices on the device, and the part of its strength that each cell takes. They take
/// memory only while there is a target.
class DeviceTarget {
 public:
  /// Copies what is of another version; another strength copies nothing. Needs: no running kernel
  /// reads them.
  void set(Stream& stream, const TargetView& target);

  const NewTarget& view() const { return view_; }
  uint64_t byte_count() const { return cells_.byte_count() + part_.byte_count(); }

 private:
  DeviceArray<TargetMatrices> cells_;  // empty without a target
  DeviceArray<float> part_;            // empty: 1 in all
  TargetView last_;                    // its cells may be gone
  NewTarget view_ = {};
};

}  // namespace burnish::cuda

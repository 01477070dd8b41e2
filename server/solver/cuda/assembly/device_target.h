#pragma once

#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A target's matrices on the device. They take memory only while there is a target.
class DeviceTarget {
 public:
  /// Copies the matrices if they are of another version; another strength copies nothing. Needs: no
  /// running kernel reads them.
  void set(Stream& stream, const TargetView& target);

  const NewTarget& view() const { return view_; }
  uint64_t byte_count() const { return cells_.byte_count(); }

 private:
  DeviceArray<TargetMatrices> cells_;  // empty without a target
  uint64_t version_ = 0;
  NewTarget view_ = {};
};

}  // namespace burnish::cuda

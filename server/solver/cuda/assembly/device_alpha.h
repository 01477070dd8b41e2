#pragma once

#include <vector>

#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A session's metric as its kernels find it: the curve and overrides, from which they work out α
/// of each cell.
class DeviceAlpha {
 public:
  explicit DeviceAlpha(Stream& stream) : source_(stream, 1) {}

  /// Needs: no kernel that reads it is under way.
  void set(Stream& stream, const MetricView& metric);
  const AlphaSource* data() const { return source_.data(); }
  uint64_t byte_count() const { return source_.byte_count() + own_.byte_count(); }

 private:
  DeviceArray<AlphaSource> source_;
  DeviceArray<OwnAlpha> own_;
};

}  // namespace burnish::cuda

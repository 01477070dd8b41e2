#pragma once

#include <vector>

#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A session's metric for its kernels: the curve and overrides. The kernels compute α of each cell
/// from them.
class DeviceAlpha {
 public:
  explicit DeviceAlpha(Stream& stream) : source_(stream, 1) {}

  /// Needs: no running kernel reads it.
  void set(Stream& stream, const MetricView& metric);
  const AlphaSource* data() const { return source_.data(); }
  uint64_t byte_count() const { return source_.byte_count() + own_.byte_count(); }

 private:
  DeviceArray<AlphaSource> source_;
  DeviceArray<OwnAlpha> own_;
};

}  // namespace burnish::cuda

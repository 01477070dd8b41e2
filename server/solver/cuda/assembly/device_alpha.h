#pragma once

#include <vector>

#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A session's metric for its kernels: the curve, overrides and held lines. The kernels compute α
/// of each cell from them.
class DeviceAlpha {
 public:
  explicit DeviceAlpha(Stream& stream) : source_(stream, 1) {}

  /// Needs: no running kernel reads it.
  void set(Stream& stream, const MetricView& metric);
  const AlphaSource* data() const { return source_.data(); }
  uint64_t byte_count() const {
    return source_.byte_count() + own_.byte_count() + lines_.byte_count() +
           first_line_.byte_count();
  }

 private:
  void set_lines(Stream& stream, const LineView& held);

  DeviceArray<AlphaSource> source_;
  DeviceArray<OwnAlpha> own_;
  DeviceArray<HeldLine> lines_;
  DeviceArray<int32_t> first_line_;
  std::vector<int32_t> line_cells_;  // of lines_
};

}  // namespace burnish::cuda

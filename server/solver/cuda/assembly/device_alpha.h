#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/edit/transfer_curve.h"
#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A session's metric for its kernels: the curve, overrides and held lines. The kernels compute α
/// of each cell from them.
class DeviceAlpha {
 public:
  explicit DeviceAlpha(Stream& stream) : source_(stream, 1) {}

  /// Needs: no running kernel or copy reads it.
  void set(Stream& stream, const MetricView& metric);
  /// Returns the cells whose α or line the last set() may have changed; null if all cells may have
  /// another one, as with another curve. Each comes once.
  const std::vector<int32_t>* changed() const { return follows_last_ ? &changed_ : nullptr; }
  const AlphaSource* data() const { return source_.data(); }
  uint64_t byte_count() const {
    return source_.byte_count() + own_.byte_count() + lines_.byte_count() +
           first_line_.byte_count();
  }

 private:
  void find_changed(const MetricView& metric);
  void add_changed_lines(std::span<const LineMass> lines);
  void set_own(Stream& stream, std::span<const OwnFields> of_cells);
  void set_lines(Stream& stream, const LineView& held);

  DeviceArray<AlphaSource> source_;
  PinnedArray<OwnAlpha> own_of_host_;  // the first own_count_ are those of the last set()
  DeviceArray<OwnAlpha> own_;
  size_t own_count_ = 0;
  DeviceArray<HeldLine> lines_;
  DeviceArray<int32_t> first_line_;
  std::vector<int32_t> line_cells_;  // of lines_
  std::optional<TransferCurve> curve_;
  bool follows_last_ = false;
  std::vector<int32_t> changed_;
};

}  // namespace burnish::cuda

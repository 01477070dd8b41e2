#pragma once

#include <vector>

#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// β of the cells on its way to the device. The slider goes with the kernels. The device reads only
/// the chunks with new paint, from memory of the host.
class GradientScale {
 public:
  /// Begins without paint and with the slider's default.
  GradientScale(Stream& stream, size_t cells);

  /// Needs: no running kernel reads it.
  void set(const FieldsView& fields);
  const NewGradientScale& view() const { return view_; }
  uint64_t byte_count() const { return paint_.byte_count(); }

 private:
  void find_painted(const CellPaint& paint);
  bool take(const CellPaint& paint, int64_t chunk);
  void list_changed();
  void gather_changed();

  PinnedArray<Paint> host_, changed_;  // all cells at the last set(); the listed chunks
  DeviceArray<Paint> paint_;
  std::vector<uint8_t> has_paint_;   // per chunk
  std::vector<int32_t> painted_;     // chunks that have paint or had some at the last set(), rising
  std::vector<uint8_t> is_changed_;  // per chunk of these; has room for all
  NewGradientScale view_;
};

}  // namespace burnish::cuda

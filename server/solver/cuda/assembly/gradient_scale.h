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
  bool take(const CellPaint& paint, int64_t chunk);
  void list_changed();
  void gather_changed();

  PinnedArray<Paint> host_, changed_;  // all cells at the last set(); the listed chunks
  DeviceArray<Paint> paint_;
  std::vector<uint8_t> has_paint_, is_changed_;  // per chunk
  NewGradientScale view_;
};

}  // namespace burnish::cuda

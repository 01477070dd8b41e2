#pragma once

#include <vector>

#include "server/fields/fields_view.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// β of the cells on its way to the device: the slider goes with the kernels, and of paint those
/// chunks of cells alone are read from memory of the host where some is new.
class GradientScale {
 public:
  /// No paint, and the slider where it is at first.
  GradientScale(Stream& stream, size_t cells);

  /// Needs: no kernel that reads it is under way.
  void set(const FieldsView& fields);
  const NewGradientScale& view() const { return view_; }
  uint64_t byte_count() const { return paint_.byte_count(); }

 private:
  bool take(const CellPaint& paint, int64_t chunk);
  void list_changed();
  void gather_changed();

  PinnedArray<Paint> host_, changed_;  // of all cells as of the last set(); of the listed chunks
  DeviceArray<Paint> paint_;
  std::vector<uint8_t> has_paint_, is_changed_;  // of each chunk
  NewGradientScale view_;
};

}  // namespace burnish::cuda

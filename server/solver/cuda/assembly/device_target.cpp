#include "server/solver/cuda/assembly/device_target.h"

namespace burnish::cuda {

static_assert(sizeof(TargetMatrices) == sizeof(TargetGradient));

void DeviceTarget::set(Stream& stream, const TargetView& target) {
  const bool is_active = target.is_active(), was_active = cells_.size() > 0;
  const bool has_new_cells = is_active && !(was_active && target.version == version_);
  if (has_new_cells || !is_active) cells_ = {};  // before others come: there may be room for one
  if (has_new_cells) cells_ = DeviceArray<TargetMatrices>::copy_of(stream, target.cells);
  version_ = target.version;
  const double strength = is_active ? target.strength : 0;
  view_ = {cells_.data(), strength, has_new_cells || strength != view_.strength};
}

}  // namespace burnish::cuda

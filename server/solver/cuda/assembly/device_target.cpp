#include "server/solver/cuda/assembly/device_target.h"

namespace burnish::cuda {

static_assert(sizeof(TargetMatrices) == sizeof(TargetGradient));

void DeviceTarget::set(Stream& stream, const TargetView& target) {
  const bool is_active = target.is_active(), was_active = cells_.size() > 0;
  const bool has_new_cells = is_active && !(was_active && target.version == last_.version);
  const bool has_new_part = is_active && !(was_active && target.part_version == last_.part_version);
  if (has_new_cells || !is_active) cells_ = {};  // before others come: there may be room for one
  if (has_new_part || !is_active) part_ = {};
  if (has_new_cells) cells_ = DeviceArray<TargetMatrices>::copy_of(stream, target.cells);
  if (has_new_part && !target.part.empty())
    part_ = DeviceArray<float>::copy_of(stream, target.part);
  view_ = {cells_.data(), part_.data(), is_active ? target.strength : 0, !target.is_same(last_)};
  last_ = target;
}

}  // namespace burnish::cuda

#include "server/fields/connected_dabs.h"

#include <utility>

namespace burnish {

ConnectedDabs::ConnectedDabs(const PreparedMesh& prepared, const Brush& brush,
                             std::vector<Vec3d> centres, std::vector<int64_t> cells)
    : brush_(brush),
      centres_(std::move(centres)),
      near_(prepared, std::move(cells)),
      left_(near_.cells().size(), 1) {}

bool ConnectedDabs::advance(size_t cells) {
  for (size_t done = 0; done < cells && next_ < centres_.size();) {
    if (!std::exchange(is_in_dab_, true)) near_.begin(centres_[next_], brush_.radius);
    const std::span<const SurfaceNear::Reached> ring = near_.next_ring();
    for (const auto& [index, distance] : ring)
      left_[index] *=
          1 - brush_.strength * fall_off_weight(brush_.fall_off, distance / brush_.radius);
    done += ring.size();
    if (!ring.empty()) continue;
    is_in_dab_ = false;
    ++next_;
    ++done;
  }
  return next_ == centres_.size();
}

}  // namespace burnish

#include "client/tools/stroke_tint.h"

#include <cmath>

#include <Eigen/Geometry>

namespace burnish {

StrokeTint::StrokeTint(const PageGrid& grid, int depth)
    : origin_(grid.origin), cell_size_(std::ldexp(grid.side, -depth)) {}

void StrokeTint::add_dab(const Brush& brush, const Vec3d& centre) {
  dabs_.push_back({((centre - origin_) / cell_size_).cast<float>(),
                   static_cast<float>(brush.radius / cell_size_),
                   static_cast<float>(brush.strength), brush.fall_off});
}

void StrokeTint::clear() {
  if (dabs_.empty()) return;
  dabs_.clear();
  ++stroke_;
}

bool StrokeTint::update(std::span<const Vec3i> cells, TintProgress& progress,
                        std::vector<float>& weights) const {
  bool changed = false;
  if (progress.stroke != stroke_) {
    changed = !weights.empty();
    weights.clear();
    progress = {stroke_, 0};
  }
  if (progress.dabs == dabs_.size()) return changed;
  Eigen::AlignedBox3f box;
  for (const Vec3i& cell : cells) box.extend(cell.cast<float>() + Vec3f::Constant(0.5f));
  for (; progress.dabs < dabs_.size(); ++progress.dabs) {
    const Dab& dab = dabs_[progress.dabs];
    if (box.squaredExteriorDistance(dab.centre) >= dab.radius * dab.radius) continue;
    weights.resize(cells.size(), 0.0f);
    changed |= blend(dab, cells, weights);
  }
  return changed;
}

bool StrokeTint::blend(const Dab& dab, std::span<const Vec3i> cells, std::span<float> weights) {
  bool changed = false;
  for (size_t c = 0; c < cells.size(); ++c) {
    const Vec3f centre = cells[c].cast<float>() + Vec3f::Constant(0.5f);
    const float part = (centre - dab.centre).norm() / dab.radius;
    if (part >= 1) continue;
    const auto weight = static_cast<float>(dab.strength * fall_off_weight(dab.fall_off, part));
    weights[c] += weight * (1 - weights[c]);
    changed = true;
  }
  return changed;
}

}  // namespace burnish

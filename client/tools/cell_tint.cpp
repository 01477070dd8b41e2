#include "client/tools/cell_tint.h"

#include <algorithm>

namespace burnish {

static constexpr size_t kBlockCells = 512;

IndexRange united(const IndexRange& a, const IndexRange& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  const size_t first = std::min(a.first, b.first);
  return {first, std::max(a.first + a.count, b.first + b.count) - first};
}

CellTint::CellTint(const View& view) : frame_(view.frame), weights_(view.grid.cells.size(), 0.0f) {
  centres_.reserve(view.grid.cells.size());
  for (const GridKey& cell : view.grid.cells)
    centres_.push_back(morton_point(cell.place).cast<float>() + Vec3f::Constant(0.5f));
  for (size_t first = 0; first < centres_.size(); first += kBlockCells) {
    Block block{{}, {first, std::min(kBlockCells, centres_.size() - first)}};
    for (size_t c = first; c < first + block.cells.count; ++c) block.box.extend(centres_[c]);
    blocks_.push_back(block);
  }
}

IndexRange CellTint::blend(const Block& block, const Brush& brush, const Vec3f& centre,
                           float radius) {
  IndexRange changed;
  for (size_t c = block.cells.first; c < block.cells.first + block.cells.count; ++c) {
    const float part = (centres_[c] - centre).norm() / radius;
    if (part >= 1) continue;
    const auto weight = static_cast<float>(brush.strength * fall_off_weight(brush.fall_off, part));
    weights_[c] += weight * (1 - weights_[c]);
    changed = united(changed, {c, 1});
  }
  return changed;
}

IndexRange CellTint::add_dab(const Brush& brush, const Vec3d& centre) {
  const Vec3f at = frame_.to_grid(centre).cast<float>();
  const auto radius = static_cast<float>(brush.radius / frame_.cell_size);
  IndexRange changed;
  for (const Block& block : blocks_) {
    if (block.box.squaredExteriorDistance(at) > radius * radius) continue;
    changed = united(changed, blend(block, brush, at, radius));
  }
  touched_ = united(touched_, changed);
  return changed;
}

IndexRange CellTint::clear() {
  const IndexRange changed = touched_;
  std::fill_n(weights_.begin() + changed.first, changed.count, 0.0f);
  touched_ = {};
  return changed;
}

}  // namespace burnish

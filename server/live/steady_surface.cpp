#include "server/live/steady_surface.h"

#include <algorithm>
#include <utility>

namespace burnish {

static constexpr int kBrickKeyBits = 6;  // 4 corners a side

static MortonKey brick_key(const GridKey& key) {
  return key.place >> kBrickKeyBits;
}

SteadySurface::SteadySurface(const SparseGrid& grid, std::span<const EvaluationPoint> scan,
                             float distance, Quota::Share memory)
    : grid_(grid), scan_(scan), distance_(distance), memory_(std::move(memory)) {
  for (size_t i = 0; i < grid.corners.size(); ++i)
    if (bricks_.empty() || bricks_.back().key != brick_key(grid.corners[i]))
      bricks_.push_back({brick_key(grid.corners[i]), i});
  rest();
}

uint64_t SteadySurface::byte_count(const SparseGrid& grid) {
  uint64_t bricks = 0;
  for (size_t i = 0; i < grid.corners.size(); ++i)
    bricks += i == 0 || brick_key(grid.corners[i]) != brick_key(grid.corners[i - 1]);
  constexpr uint64_t kBytesPerBrick = 2 * sizeof(Brick) + 2;  // the vector of bricks grows
  return (sizeof(Vec3f) + 1) * grid.corners.size() + kBytesPerBrick * bricks;
}

void SteadySurface::rest() {
  moves_.assign(bricks_.size(), 0);
  all_move_ = false;
}

std::span<const Vec3f> SteadySurface::show_all(std::span<const Vec3f> displacement) {
  shown_.assign(displacement.begin(), displacement.end());
  is_behind_ = false;
  return shown_;
}

std::span<const Vec3f> SteadySurface::show(std::span<const Vec3f> displacement) {
  if (shown_.empty() || all_move_) return show_all(displacement);
  const Marks corners = find_moved_corners(displacement);
  const auto moved_corners = std::ranges::count(corners, 1);
  all_move_ = 2 * static_cast<size_t>(moved_corners) > corners.size();
  if (all_move_) return show_all(displacement);
  if (moved_corners > 0) {
    const Marks moved = find_moved_bricks(displacement, corners);
    for (size_t brick = 0; brick < bricks_.size(); ++brick)
      if (moved[brick]) move_around(brick);
  }
  move_bricks(displacement);
  is_behind_ = !std::equal(shown_.begin(), shown_.end(), displacement.begin());
  return shown_;
}

SteadySurface::Marks SteadySurface::find_moved_corners(std::span<const Vec3f> displacement) const {
  const float limit = distance_ * distance_;
  Marks moved(shown_.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < shown_.size(); ++i)
    moved[i] = (displacement[i] - shown_[i]).squaredNorm() > limit;
  return moved;
}

// A vertex moves no further than the corners of its cell, so few vertices are evaluated.
SteadySurface::Marks SteadySurface::find_moved_bricks(std::span<const Vec3f> displacement,
                                                      const Marks& corners) const {
  const std::span<const Vec3f> shown = shown_;
  const float limit = distance_ * distance_;
  const auto may_move = [&](int32_t cell) {
    return std::ranges::any_of(grid_.cell_corners[cell], [&](int32_t c) { return corners[c]; });
  };
  Marks moved(bricks_.size());
#pragma omp parallel for schedule(dynamic, 4096)
  for (size_t i = 0; i < scan_.size(); ++i) {
    const EvaluationPoint& point = scan_[i];
    if (point.cell == kNone || !may_move(point.cell)) continue;
    const Vec3f move = evaluate(grid_, point, displacement) - evaluate(grid_, point, shown);
    if (move.squaredNorm() <= limit) continue;
    const auto brick = find_brick(brick_key(grid_.cells[point.cell]));
    if (!brick) continue;
#pragma omp atomic write
    moved[*brick] = 1;
  }
  return moved;
}

void SteadySurface::move_bricks(std::span<const Vec3f> displacement) {
  for (size_t brick = 0; brick < bricks_.size(); ++brick) {
    if (!moves_[brick]) continue;
    const size_t first = bricks_[brick].first;
    const size_t end = brick + 1 < bricks_.size() ? bricks_[brick + 1].first : shown_.size();
    std::copy(displacement.begin() + first, displacement.begin() + end, shown_.begin() + first);
  }
}

std::optional<size_t> SteadySurface::find_brick(MortonKey key) const {
  const auto found = std::ranges::lower_bound(bricks_, key, {}, &Brick::key);
  if (found == bricks_.end() || found->key != key) return std::nullopt;
  return static_cast<size_t>(found - bricks_.begin());
}

// Its neighbours too: no cell with a moved vertex has a corner that stays behind.
void SteadySurface::move_around(size_t brick) {
  const Vec3i middle = morton_point(bricks_[brick].key);
  for (int i = 0; i < 27; ++i) {
    const Vec3i place = middle + Vec3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if ((place.array() < 0).any()) continue;
    if (const auto near = find_brick(morton_key(place))) moves_[*near] = 1;
  }
}

}  // namespace burnish

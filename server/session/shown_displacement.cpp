#include "server/session/shown_displacement.h"

#include <algorithm>

namespace burnish {

static constexpr int kUsesPerMeasure = 8;

// A length that rounds above the cap would pass it by a float's last bit.
static constexpr double kBelowCap = 1 - 1e-6;

static void clamp_lengths(std::span<Vec3f> displacement, double cells_max) {
  const auto most = static_cast<float>(kBelowCap * cells_max);
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < displacement.size(); ++corner) {
    const float length = displacement[corner].norm();
    if (length > most) displacement[corner] *= most / length;
  }
}

static void still(const SparseGrid& grid, const Hold& hold, std::span<Vec3f> displacement) {
  for (const int32_t cell : hold.cells)
    for (const int32_t corner : grid.cell_corners[cell]) displacement[corner].setZero();
}

std::span<const Vec3f> ShownDisplacement::of(std::span<const Vec3f> solved,
                                             const Controls& controls, const Fields& fields,
                                             bool is_exact) {
  if (!controls.keep_volume) {
    volume_.reset();
    kept_volume_.reset();
  }
  if (!is_needed(controls, fields)) return solved;
  shown_.assign(solved.begin(), solved.end());
  if (controls.keep_volume) return keep_volume(solved, controls, fields, is_exact);
  bound(controls, fields);
  return shown_;
}

void ShownDisplacement::bound(const Controls& controls, const Fields& fields) {
  if (fields.rims()) anchor_rims(fields);
  if (controls.cap > 0) clamp_lengths(shown_, controls.cap / prepared_.frame.cell_size);
  if (fields.hold()) still(grid_, *fields.hold(), shown_);
}

void ShownDisplacement::anchor_rims(const Fields& fields) {
  if (!anchor_ || anchor_->rims() != fields.rims())
    anchor_.emplace(prepared_, grid_, fields.rims());
  anchor_->apply(shown_);
}

std::span<const Vec3f> ShownDisplacement::keep_volume(std::span<const Vec3f> solved,
                                                      const Controls& controls,
                                                      const Fields& fields, bool is_exact) {
  if (!volume_) {
    volume_.emplace(prepared_, grid_);
    uses_ = kUsesPerMeasure;
  }
  const auto shown_at = [&](double distance) -> std::span<const Vec3f> {
    std::copy(solved.begin(), solved.end(), shown_.begin());
    volume_->apply(distance, shown_);
    bound(controls, fields);
    return shown_;
  };
  if (is_exact || uses_ >= kUsesPerMeasure) {
    volume_->measure(solved, fields.edited());
    if (controls.cap > 0 || fields.hold() || fields.rims())
      volume_->measure_bounded(shown_at, is_exact);
    kept_volume_ = volume_->kept();
    uses_ = 0;
  }
  ++uses_;
  return shown_at(volume_->distance());
}

}  // namespace burnish

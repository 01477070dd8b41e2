#include "server/solver/cpu/assembly/constraint.h"

#include <algorithm>
#include <utility>

#include "common/base/dispatch.h"
#include "server/solver/cpu/scratch.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cpu {

// With fewer changed cells than this part of all, their corners are summed one by one. A cell's
// share is then computed anew for each of its corners.
static constexpr int64_t kFewCellsDivisor = 8;

namespace {

// The last corner's share is minus the sum of the others, because Σ_a ∇B_a = 0.
BURNISH_DISPATCH void combine(const CellIntegrals& of, double first, double second,
                              std::array<double, 24>& out) {
  std::array<double, kPairsPerCell> pair;
  for (int p = 0; p < kPairsPerCell; ++p)
    pair[p] = first * of.stiffness[0][p] + second * of.stiffness[1][p];
#pragma GCC unroll 3
  for (int axis = 0; axis < 3; ++axis) {
    double others = 0;
#pragma GCC unroll 7
    for (int a = 0; a < 7; ++a)
      others += out[3 * a + axis] = gradient_of([&](int p) { return pair[p]; }, a, axis);
    out[21 + axis] = -others;
  }
}

}  // namespace

std::vector<double> ratios_of(const CellAlphas& alphas) {
  std::vector<double> ratios(alphas.alpha1.size());
  for (size_t c = 0; c < ratios.size(); ++c)
    ratios[c] = static_cast<double>(alphas.alpha2[c]) / alphas.alpha1[c];
  return ratios;
}

Constraint::Constraint(const PreparedMesh& prepared, const CpuDepth& finest)
    : prepared_(prepared),
      finest_(finest),
      ratio_(prepared.cells.size(), 1),
      per_slider_(finest.corner_count(), Double3::Zero()),
      is_pinned_(finest.corner_count(), 0),
      paint_(prepared.cells.size()),
      has_paint_((prepared.cells.size() + CellPaint::kStretch - 1) / CellPaint::kStretch, 0),
      is_changed_(prepared.cells.size(), 0) {}

void Constraint::set_ratio(std::vector<double> ratio) {
  for (size_t c = 0; c < ratio.size(); ++c)
    if (ratio[c] != ratio_[c]) new_ratios_.push_back(static_cast<int32_t>(c));
  ratio_ = std::move(ratio);
  pins_are_new_ = true;
}

void Constraint::assemble(const FieldsView& fields, std::vector<Double3>& b,
                          std::vector<Double3>& r) {
  const int64_t changed = take(fields.paint) + take_ratios() + take(fields.target);
  const double by = fields.gradient_scale - std::exchange(slider_, fields.gradient_scale);
  const auto few = static_cast<int64_t>(paint_.size()) / kFewCellsDivisor;
  const bool pins_are_new = std::exchange(pins_are_new_, false);
  if (std::exchange(is_new_, false) || changed > few) return sum_all(b, r);
  if (by != 0) slide(by, b, r);
  if (changed > 0 || pins_are_new) sum_changed(b, r);
}

// Returns how many cells have another paint.
int64_t Constraint::take(const CellPaint& paint) {
  int64_t changed = 0;
#pragma omp parallel for schedule(static) reduction(+ : changed)
  for (size_t stretch = 0; stretch < has_paint_.size(); ++stretch)
    changed += take_stretch(paint, stretch);
  is_painted_ = std::ranges::count(has_paint_, 0) < std::ssize(has_paint_);
  return changed;
}

int64_t Constraint::take_stretch(const CellPaint& paint, size_t stretch) {
  const size_t begin = stretch * CellPaint::kStretch;
  const size_t end = std::min(begin + CellPaint::kStretch, paint_.size());
  std::fill(&is_changed_[begin], &is_changed_[begin] + (end - begin), uint8_t{0});
  if (!has_paint_[stretch] && !paint.is_painted[stretch]) return 0;
  has_paint_[stretch] = paint.is_painted[stretch];
  int64_t changed = 0;
  for (size_t c = begin; c < end; ++c) {
    const Paint next = {paint.follow[c], paint.own[c]};
    is_changed_[c] = next != paint_[c];
    changed += is_changed_[c];
    paint_[c] = next;
  }
  return changed;
}

// Returns how many more cells have another part of the target's strength. All are new with another
// target.
int64_t Constraint::take(const TargetView& target) {
  const TargetView before = std::exchange(target_, target);
  if (target.is_same(before)) return 0;
  TargetView of_before = target;
  of_before.part_version = before.part_version;
  is_new_ |= !of_before.is_same(before);
  return take_part(target.is_active() ? target.part : std::span<const float>());
}

int64_t Constraint::take_part(std::span<const float> part) {
  is_new_ |= part.size() != target_part_.size();
  int64_t changed = 0;
  for (size_t c = 0; !is_new_ && c < part.size(); ++c)
    if (part[c] != target_part_[c]) changed += mark(static_cast<int32_t>(c));
  target_part_.assign(part.begin(), part.end());
  return changed;
}

void Constraint::set_signal(std::span<const Vec3f> signal) {
  signal_.assign(signal.begin(), signal.end());
  is_new_ = true;
}

// Returns how many more cells have another ratio.
int64_t Constraint::take_ratios() {
  int64_t changed = 0;
  for (const int32_t cell : std::exchange(new_ratios_, {})) changed += mark(cell);
  return changed;
}

void Constraint::share(int32_t cell, CellShare& out) const {
  if (!signal_.empty()) return share_of_signal(cell, out);
  combine(prepared_.integrals[cell], ratio_[cell], 1 / ratio_[cell], out);
}

// Σ_b ℓ_ab s_b. Rows of ℓ add up to zero, so only differences count: a constant has no share.
void Constraint::share_of_signal(int32_t cell, CellShare& out) const {
  const CellIntegrals& of = prepared_.integrals[cell];
  const auto& corners = finest_.topology.grid.cell_corners[cell];
  const double first = ratio_[cell], second = 1 / ratio_[cell];
  out.fill(0);
  for (int a = 0; a < kCornersPerCell; ++a) {
    for (int b = a + 1; b < kCornersPerCell; ++b) {
      const int pair = pair_index(a, b);
      const double stiffness = first * of.stiffness[0][pair] + second * of.stiffness[1][pair];
      for (int axis = 0; axis < 3; ++axis) {
        const double step =
            stiffness * (double{signal_[corners[b]][axis]} - double{signal_[corners[a]][axis]});
        out[3 * a + axis] += step;
        out[3 * b + axis] -= step;
      }
    }
  }
}

// Without paint and target b is set, not moved by steps, so that it is exactly zero again at β = 1.
void Constraint::slide(double by, std::vector<Double3>& b, std::vector<Double3>& r) const {
  const bool has_own = is_painted_ || target_.is_active();
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < per_slider_.size(); ++i) {
    const Double3 before = b[i];
    b[i] = has_own ? Double3(before + by * per_slider_[i]) : (slider_ - 1) * per_slider_[i];
    r[i] += b[i] - before;
  }
}

// Adds a cell's share at one of its corners to those of the corner.
void Constraint::add_share(int32_t cell, const double* share, CornerSums& sums) const {
  const Paint paint = is_painted_ ? paint_[cell] : Paint();
  double scaled[3] = {share[0], share[1], share[2]};
  if (target_.is_active()) {
    const TargetGradient& target = target_.cells[cell];
    const double strength = target_.strength_in(cell);
    for (int row = 0; row < 3; ++row) {
      double of_scale = 0, of_target = 0;
      for (int i = 0; i < 3; ++i) {
        of_scale += target.of_scale[3 * row + i] * share[i];
        of_target += target.of_target[3 * row + i] * share[i];
      }
      scaled[row] += strength * of_scale;
      sums.own[row] += strength * of_target;
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    sums.of_slider[axis] += paint.follow * scaled[axis];
    sums.own[axis] += paint.own * scaled[axis];
  }
}

// Sums `share_of` over the cells around a corner.
template <typename ShareOf>
void Constraint::sum_corner(int32_t corner, ShareOf&& share_of, Double3& b, Double3& r) {
  CornerSums sums;
  for (int a = 0; a < kCornersPerCell; ++a) {
    const int32_t cell = finest_.topology.grid.cells_of_corner[corner][a];
    if (cell != kNone) add_share(cell, &share_of(cell)[3 * a], sums);
  }
  is_pinned_[corner] = finest_.inverse_diagonal[corner] == 0;
  if (is_pinned_[corner]) sums = {};
  per_slider_[corner] = sums.of_slider;
  const Double3 before = std::exchange(b, (slider_ - 1) * sums.of_slider + sums.own);
  r += b - before;
}

void Constraint::sum_all(std::vector<Double3>& b, std::vector<Double3>& r) {
  Scratch<CellShare> shares(ratio_.size());
#pragma omp parallel for schedule(static)
  for (size_t cell = 0; cell < ratio_.size(); ++cell)
    share(static_cast<int32_t>(cell), shares[cell]);
  const auto share_of = [&](int32_t cell) -> const CellShare& { return shares[cell]; };
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < finest_.corner_count(); ++corner)
    sum_corner(corner, share_of, b[corner], r[corner]);
}

bool Constraint::is_pin_new(int32_t corner) const {
  return is_pinned_[corner] != (finest_.inverse_diagonal[corner] == 0);
}

// Sums only the corners of cells with new paint or ratios, and those that became pinned or free.
void Constraint::sum_changed(std::vector<Double3>& b, std::vector<Double3>& r) {
  const auto is_changed = [&](int32_t cell) { return cell != kNone && is_changed_[cell] != 0; };
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < finest_.corner_count(); ++corner) {
    if (!is_pin_new(corner) &&
        std::ranges::none_of(finest_.topology.grid.cells_of_corner[corner], is_changed))
      continue;
    CellShare room;
    const auto share_of = [&](int32_t cell) -> const CellShare& {
      share(cell, room);
      return room;
    };
    sum_corner(corner, share_of, b[corner], r[corner]);
  }
}

uint64_t Constraint::byte_count() const {
  return bytes_of(ratio_) + bytes_of(signal_) + bytes_of(per_slider_) + bytes_of(is_pinned_) +
         bytes_of(paint_) + bytes_of(has_paint_) + bytes_of(is_changed_) + bytes_of(target_part_);
}

}  // namespace burnish::cpu

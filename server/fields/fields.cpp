#include "server/fields/fields.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "common/grid/morton.h"

namespace burnish {

// With fewer cells, one thread is done with β before others wake. The second limit is cells times
// dabs of a brush.
static constexpr size_t kParallelMin = 1 << 18;
static constexpr size_t kPaintParallelMin = 1 << 13;

Fields::Fields(const PreparedMesh& prepared)
    : prepared_(prepared),
      painted_beta_(prepared.cells.size(), 0),
      painted_weight_(prepared.cells.size(), 0),
      may_have_paint_((prepared.cells.size() + kStretch - 1) / kStretch, 0),
      beta_(prepared.cells.size(), static_cast<float>(kBetaDefault)),
      follow_(prepared.cells.size(), 1),
      own_(prepared.cells.size(), 0) {}

void Fields::set_transfer_curve(const TransferCurve& curve) {
  curve_ = curve;
  held_own_is_old_ = true;
}

void Fields::set_gradient_scale(double beta) {
  beta_slider_ = beta;
  beta_is_old_ = true;
}

namespace {

struct Box {
  Vec3d least, most;
  bool contains(const Vec3d& p) const {
    return (p.array() >= least.array()).all() && (p.array() <= most.array()).all();
  }
};

Box box_of(std::span<const Vec3d> centres, double radius) {
  Box box{centres.front(), centres.front()};
  for (const Vec3d& centre : centres) {
    box.least = box.least.cwiseMin(centre);
    box.most = box.most.cwiseMax(centre);
  }
  return {box.least - Vec3d::Constant(radius), box.most + Vec3d::Constant(radius)};
}

/// Finds the cells in a box, and few others. The cells of each octant of the grid are a range of
/// the Morton order. Without this, a dab on a large scan would take as long as the scan is large.
class CellsInBox {
 public:
  CellsInBox(std::span<const MortonKey> cells, const GridFrame& frame, const Box& box)
      : cells_(cells), least_(frame.to_grid(box.least)), most_(frame.to_grid(box.most)) {
    add(0, frame.depth, 0, static_cast<int64_t>(cells.size()));
  }

  /// Rising.
  const std::vector<int64_t>& found() const { return found_; }

 private:
  static constexpr int kLeafDepth = 2;  // an octant of 4³ cells is taken as a whole

  void add(MortonKey first, int depth, int64_t begin, int64_t end) {
    const Vec3d low = morton_point(first).cast<double>();
    const Vec3d high = low + Vec3d::Constant(1 << depth);
    if (begin == end || (low.array() > most_.array()).any() ||
        (high.array() < least_.array()).any())
      return;
    if (depth <= kLeafDepth) {
      for (int64_t c = begin; c < end; ++c) found_.push_back(c);
      return;
    }
    const MortonKey keys = MortonKey{1} << 3 * (depth - 1);  // per child
    for (MortonKey child = first; child < first + 8 * keys; child += keys) {
      const auto stop =
          std::lower_bound(cells_.begin() + begin, cells_.begin() + end, child + keys);
      const int64_t child_end = stop - cells_.begin();
      add(child, depth - 1, begin, child_end);
      begin = child_end;
    }
  }

  std::span<const MortonKey> cells_;
  Vec3d least_, most_;  // grid units
  std::vector<int64_t> found_;
};

}  // namespace

std::vector<int64_t> Fields::cells_near(const Brush& brush, std::span<const Vec3d> centres) const {
  return CellsInBox(prepared_.cells, prepared_.frame, box_of(centres, brush.radius)).found();
}

void Fields::paint(const Brush& brush, std::span<const Vec3d> centres,
                   std::span<const int64_t> cells) {
  const Box box = box_of(centres, brush.radius);
  for (const int64_t c : cells) may_have_paint_[c / kStretch] = 1;
  const bool is_long = cells.size() * centres.size() >= kPaintParallelMin;
#pragma omp parallel for schedule(dynamic, 256) if (is_long)
  for (size_t i = 0; i < cells.size(); ++i) {
    const int64_t c = cells[i];
    const Vec3i cell = morton_point(prepared_.cells[c]);
    const Vec3d middle = prepared_.frame.to_file(cell.cast<double>() + Vec3d::Constant(0.5));
    if (!box.contains(middle)) continue;
    double beta = painted_beta_[c], covered = painted_weight_[c];
    for (const Vec3d& centre : centres) {
      const double weight =
          brush.strength * fall_off_weight(brush.fall_off, (middle - centre).norm() / brush.radius);
      if (weight <= 0) continue;
      const double under = covered * (1 - weight);
      covered = under + weight;
      beta = (beta * under + brush.beta * weight) / covered;
      if (covered == 1 && beta == brush.beta) break;  // later dabs paint the same over it
    }
    painted_beta_[c] = static_cast<float>(beta);
    painted_weight_[c] = static_cast<float>(covered);
  }
  beta_is_old_ = true;
}

PaintedCells Fields::painted() const {
  PaintedCells painted;
  for (size_t stretch = 0; stretch < may_have_paint_.size(); ++stretch) {
    if (!may_have_paint_[stretch]) continue;
    const size_t end = std::min((stretch + 1) * kStretch, painted_weight_.size());
    for (size_t c = stretch * kStretch; c < end; ++c) {
      if (painted_weight_[c] == 0 && painted_beta_[c] == 0) continue;
      painted.cells.push_back(static_cast<int32_t>(c));
      painted.beta.push_back(painted_beta_[c]);
      painted.weight.push_back(painted_weight_[c]);
    }
  }
  return painted;
}

void Fields::set_painted(const PaintedCells& painted) {
  std::fill(painted_beta_.begin(), painted_beta_.end(), 0.0f);
  std::fill(painted_weight_.begin(), painted_weight_.end(), 0.0f);
  std::fill(follow_.begin(), follow_.end(), 1.0f);
  std::fill(own_.begin(), own_.end(), 0.0f);
  std::fill(may_have_paint_.begin(), may_have_paint_.end(), uint8_t{0});
  for (const OwnFields& own : overrides_) may_have_paint_[own.cell / kStretch] = 1;
  mark_held();
  for (size_t i = 0; i < painted.cells.size(); ++i) {
    painted_beta_[painted.cells[i]] = painted.beta[i];
    painted_weight_[painted.cells[i]] = painted.weight[i];
    may_have_paint_[painted.cells[i] / kStretch] = 1;
  }
  beta_is_old_ = true;
}

Status Fields::override_cells(const SetCellFields& change) {
  std::vector<OwnFields> all = overrides_;
  for (const SetCellFields::Cell& cell : change.cells) {
    ASSIGN_OR_RETURN(const int32_t index, index_of(cell.cell));
    all.push_back({index, static_cast<float>(cell.alpha1), static_cast<float>(cell.alpha2),
                   static_cast<float>(cell.beta)});
  }
  std::ranges::stable_sort(all, {}, &OwnFields::cell);
  overrides_.clear();
  for (const OwnFields& own : all) {
    if (!overrides_.empty() && overrides_.back().cell == own.cell) overrides_.pop_back();
    overrides_.push_back(own);
    may_have_paint_[own.cell / kStretch] = 1;
  }
  beta_is_old_ = held_own_is_old_ = true;
  return Status::ok();
}

void Fields::clear_overrides() {
  overrides_.clear();
  beta_is_old_ = held_own_is_old_ = true;
}

FieldsView Fields::view() const {
  if (beta_is_old_) update_beta();
  beta_is_old_ = false;
  if (hold_ && held_own_is_old_) update_held_own();
  const std::vector<OwnFields>& own = hold_ ? held_own_ : overrides_;
  return {{&curve_, own}, beta_, beta_slider_, {follow_, own_, may_have_paint_}};
}

CellAlphas Fields::alphas() const {
  CellAlphas alphas;
  evaluate(view().metric, prepared_, alphas);
  return alphas;
}

uint64_t Fields::byte_count() const {
  return 5 * beta_.size() * sizeof(float) + may_have_paint_.size() +
         (overrides_.size() + held_own_.size()) * sizeof(OwnFields) +
         (hold_ ? hold_->byte_count() : 0);
}

void Fields::update_beta() const {
#pragma omp parallel for schedule(static) if (beta_.size() >= kParallelMin)
  for (size_t stretch = 0; stretch < may_have_paint_.size(); ++stretch) update_beta(stretch);
  for (const OwnFields& own : overrides_) {
    beta_[own.cell] = own.beta;
    follow_[own.cell] = 0;
    own_[own.cell] = own.beta - 1;
  }
  if (hold_) hold_beta();
}

void Fields::update_beta(size_t stretch) const {
  const size_t begin = stretch * kStretch, end = std::min(begin + kStretch, beta_.size());
  if (!may_have_paint_[stretch])
    return std::fill(&beta_[begin], &beta_[begin] + (end - begin),
                     static_cast<float>(beta_slider_));
  for (size_t c = begin; c < end; ++c) {
    const double weight = painted_weight_[c], painted = painted_beta_[c];
    beta_[c] = static_cast<float>((1 - weight) * beta_slider_ + weight * painted);
    follow_[c] = static_cast<float>(1 - weight);
    own_[c] = static_cast<float>(weight * (painted - 1));
  }
}

}  // namespace burnish

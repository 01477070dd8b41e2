#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "server/fields/alphas.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Returns α2/α1 of every cell.
std::vector<double> ratios_of(const CellAlphas& alphas);

/// b_I = Σ_c (β−1)(α2/α1 g¹ + α1/α2 g²)_I, the right-hand side for the displacement: Eq. 4's
/// constraint less S c°; with a target, what TargetView says. It keeps the part of b that follows
/// the slider, so a slider that moves sums nothing again. A dab sums its corners again, also one of
/// the target's strength. A new metric sums the corners of cells with another ratio of α, and those
/// that are no longer pinned.
class Constraint {
 public:
  /// Begins without paint and with β = 1 everywhere. Both arguments must live longer.
  Constraint(const PreparedMesh& prepared, const CpuDepth& finest);

  /// Takes another signal than the surface's own places. assemble() sums everything again.
  /// Shapes: one per corner.
  void set_signal(std::span<const Vec3f> signal);

  /// assemble() sums everything again.
  void start_over() { is_new_ = true; }

  /// Call after a new metric. `ratio`: α2/α1 of every cell; where it changed, assemble() sums
  /// again.
  void set_ratio(std::vector<double> ratio);
  std::span<const double> ratio() const { return ratio_; }

  /// Makes b of the fields. Changes the residual r by the same amount. Needs: b as the last call
  /// left it. Shapes: one per corner. Zero at pinned corners.
  void assemble(const FieldsView& fields, std::vector<Double3>& b, std::vector<Double3>& r);
  uint64_t byte_count() const;

 private:
  /// β = 1 + follow·(slider − 1) + own.
  struct Paint {
    float follow = 1, own = 0;
    bool operator==(const Paint&) const = default;
  };
  /// A cell's share of b for β − 1 = 1, by local corner and axis.
  using CellShare = std::array<double, 24>;
  /// Parts of b at a corner: b = (slider − 1) of_slider + own.
  struct CornerSums {
    Double3 of_slider = Double3::Zero(), own = Double3::Zero();
  };

  int64_t take(const CellPaint& paint);
  int64_t take_ratios();
  int64_t take_stretch(const CellPaint& paint, size_t stretch);
  int64_t take(const TargetView& target);
  int64_t take_part(std::span<const float> part);
  bool mark(int32_t cell) { return std::exchange(is_changed_[cell], uint8_t{1}) == 0; }
  void add_share(int32_t cell, const double* share, CornerSums& sums) const;
  void share(int32_t cell, CellShare& out) const;
  void share_of_signal(int32_t cell, CellShare& out) const;
  void slide(double by, std::vector<Double3>& b, std::vector<Double3>& r) const;
  void sum_all(std::vector<Double3>& b, std::vector<Double3>& r);
  bool is_pin_new(int32_t corner) const;
  void sum_changed(std::vector<Double3>& b, std::vector<Double3>& r);
  template <typename ShareOf>
  void sum_corner(int32_t corner, ShareOf&& share_of, Double3& b, Double3& r);

  const PreparedMesh& prepared_;
  const CpuDepth& finest_;
  std::vector<double> ratio_;
  std::vector<Vec3f> signal_;        // per corner; empty: places
  std::vector<int32_t> new_ratios_;  // cells; since the last sum
  bool is_new_ = true, pins_are_new_ = false;
  double slider_ = 1;
  std::vector<Double3> per_slider_;  // per corner: the change of b when the slider goes up by one
  std::vector<uint8_t> is_pinned_;   // per corner, at its last sum
  std::vector<Paint> paint_;
  std::vector<uint8_t> has_paint_;   // per stretch of cells: a cell of it may have paint
  std::vector<uint8_t> is_changed_;  // per cell: its paint, ratio or part of the target is new
  bool is_painted_ = false;
  TargetView target_;               // of the last assemble(); its cells are gone since
  std::vector<float> target_part_;  // of the last assemble(); empty: 1 in all
};

}  // namespace burnish::cpu

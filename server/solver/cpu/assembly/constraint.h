#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/fields/alphas.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// α2/α1 of every cell.
std::vector<double> ratios_of(const CellAlphas& alphas);

/// b_I = Σ_c (β−1)(α2/α1 g¹ + α1/α2 g²)_I, the right-hand side for the displacement: Eq. 4's
/// constraint less S c°. What of b follows the slider is kept: of a slider that moves nothing is
/// summed again, of a dab what is at its corners, of a new metric with the same ratios of α, as one
/// α for another, what is at corners that are pinned no more.
class Constraint {
 public:
  /// No paint, and β one everywhere. Both live longer.
  Constraint(const PreparedMesh& prepared, const CpuDepth& finest);

  /// After a new metric. `ratio`: α2/α1 of every cell; with another assemble() sums all anew.
  void set_ratio(std::vector<double> ratio);
  std::span<const double> ratio() const { return ratio_; }

  /// b as the fields have it; the residual r changes by as much. Needs: b as it was left the last
  /// time. Shapes: one per corner. Zero where pinned.
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

  int64_t take(const CellPaint& paint);
  int64_t take_stretch(const CellPaint& paint, size_t stretch);
  void share(int32_t cell, CellShare& out) const;
  void slide(double by, std::vector<Double3>& b, std::vector<Double3>& r) const;
  void sum_all(std::vector<Double3>& b, std::vector<Double3>& r);
  bool is_pin_new(int32_t corner) const;
  void sum_changed(std::vector<Double3>& b, std::vector<Double3>& r);
  template <typename ShareOf>
  void sum_corner(int32_t corner, ShareOf&& share_of, Double3& b, Double3& r);

  const PreparedMesh& prepared_;
  const CpuDepth& finest_;
  std::vector<double> ratio_;
  bool ratio_is_new_ = true, pins_are_new_ = false;
  double slider_ = 1;
  std::vector<Double3> per_slider_;  // of each corner: b's change as the slider goes up by one
  std::vector<uint8_t> is_pinned_;   // of each corner, when it was summed
  std::vector<Paint> paint_;
  std::vector<uint8_t> has_paint_;   // of each stretch of cells, whether any may have some
  std::vector<uint8_t> is_changed_;  // of each cell, whether its paint is new
  bool is_painted_ = false;
};

}  // namespace burnish::cpu

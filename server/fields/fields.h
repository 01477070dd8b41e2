#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/edit/edit.h"
#include "server/fields/alphas.h"
#include "server/fields/fields_view.h"
#include "server/fields/hold.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Painted β and its weight, for the cells that have paint.
struct PaintedCells {
  std::vector<int32_t> cells;  ///< indices, rising
  std::vector<float> beta, weight;
  bool operator==(const PaintedCells&) const = default;
};

/// The metric and β per cell (section 4.3), and their sources: slider, paint, curve, overrides.
/// Setting a source is cheap. The next view() computes β of the cells, once for all changes.
/// Shapes: one entry per cell of the finest depth. Units: α in user units.
class Fields {
 public:
  /// Begins with the defaults everywhere: α = 50, β = 1.
  explicit Fields(const PreparedMesh& prepared);

  void set_transfer_curve(const TransferCurve& curve);
  void set_gradient_scale(double beta);
  void paint(const Stroke& stroke) { paint(stroke.brush, dab_centres(stroke)); }
  /// Paints some dabs of a stroke. Shapes: at least one centre, file units.
  void paint(const Brush& brush, std::span<const Vec3d> centres) {
    paint(brush, centres, cells_near(brush, centres));
  }
  /// Does the same for some of the cells near them, to paint in pieces.
  void paint(const Brush& brush, std::span<const Vec3d> centres, std::span<const int64_t> cells);
  /// Returns the cells that these dabs may reach, and few others; rising.
  std::vector<int64_t> cells_near(const Brush& brush, std::span<const Vec3d> centres) const;
  /// Fails: invalid_argument that names the first cell that is not active; then nothing is changed.
  Status override_cells(const SetCellFields& change);
  /// Returns the status that override_cells() would return.
  Status check(const SetCellFields& change) const;
  /// Also refuses more cells than there are, and a cell that is set twice. For changes that are
  /// new. Fails: invalid_argument that names the count or the first such cell.
  Status check_new(const SetCellFields& change) const;
  /// Fails: invalid_argument if no dab of the stroke reaches a cell.
  Status check_new(const Stroke& stroke) const;
  void clear_overrides();
  /// Leads β to 1 and raises α in held cells, over all other sources. Null: nothing is held.
  void set_hold(std::shared_ptr<const Hold> hold);
  const std::shared_ptr<const Hold>& hold() const { return hold_; }

  PaintedCells painted() const;
  /// Replaces all paint. Needs: paint of the same prepared mesh.
  void set_painted(const PaintedCells& painted);

  FieldsView view() const;
  CellAlphas alphas() const;  ///< computed from view().metric
  const TransferCurve& transfer_curve() const { return curve_; }
  double gradient_scale() const { return beta_slider_; }
  uint64_t byte_count() const;

 private:
  void update_beta() const;
  void update_beta(size_t stretch) const;
  bool touches(const Brush& brush, const Vec3d& centre) const;
  void mark_held();
  void hold_beta() const;
  void update_held_own() const;
  /// Returns the index of an active cell. Fails: invalid_argument.
  Result<int32_t> index_of(const Vec3i& cell) const;

  const PreparedMesh& prepared_;  // must outlive the fields
  TransferCurve curve_{kAlphaDefault};
  double beta_slider_ = kBetaDefault;
  std::vector<float> painted_beta_, painted_weight_;
  // Per kStretch cells, so that painted() need not look at all of them: it is called after many
  // strokes. Cells of overrides count as painted.
  static constexpr size_t kStretch = CellPaint::kStretch;
  std::vector<uint8_t> may_have_paint_;
  std::vector<OwnFields> overrides_;  // by rising cell, each once
  std::shared_ptr<const Hold> hold_;

  // The result of slider, paint and overrides at the last view().
  mutable std::vector<float> beta_, follow_, own_;
  mutable bool beta_is_old_ = false;
  // The overrides with the hold on top, where there is one.
  mutable std::vector<OwnFields> held_own_;
  mutable bool held_own_is_old_ = false;
};

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/edit/edit.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/solver.h"

namespace burnish {

/// α1, α2 and β per cell (section 4.3), and what they come from: slider, paint, curve, overrides.
/// Shapes: one entry per cell of the finest depth. Units: α in user units.
class Fields {
 public:
  /// The defaults everywhere: α = 50, β = 1.
  explicit Fields(const PreparedMesh& prepared);

  void set_transfer_curve(const TransferCurve& curve);
  void set_gradient_scale(double beta);
  void paint(const Stroke& stroke);
  /// Fails: invalid_argument naming the first cell that is not active; then nothing is changed.
  Status override_cells(const SetCellFields& change);

  FieldsView view() const { return {alpha1_, alpha2_, beta_}; }
  const TransferCurve& transfer_curve() const { return curve_; }
  double gradient_scale() const { return beta_slider_; }

 private:
  void blend_beta();
  void override_metric();

  const PreparedMesh& prepared_;  // outlives the fields
  TransferCurve curve_{kAlphaDefault};
  double beta_slider_ = kBetaDefault;
  std::vector<float> painted_beta_, painted_weight_;
  std::vector<std::pair<int32_t, SetCellFields::Cell>> overrides_;  // by cell index, in order
  std::vector<float> alpha1_, alpha2_, beta_;
};

}  // namespace burnish

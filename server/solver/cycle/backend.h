#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "common/base/status.h"
#include "common/base/types.h"
#include "server/fields/fields_view.h"

namespace burnish {

/// Sums over the surface that one step of conjugate gradients leaves behind.
struct Measures {
  double energy = 0;                   ///< ½uᵀSu − bᵀu, grid units
  double residual = 0;                 ///< ‖D^-½ r‖ / ‖D^-½ b‖, D the diagonal of S
  double preconditioned_residual = 0;  ///< rᵀz before the step, z the V-cycle's correction of r
  double moved_max = 0;  ///< largest |E a p| at a vertex, in cells: how far the step moved it
};

/// The one seam between the algorithms, written once, and the machines that run them.
/// Every call works on whole depths. Depths run from hierarchy.coarsest to hierarchy.finest.
///
/// Each depth holds a correction x and a right-hand side f of the V-cycle; the finest also holds
/// the displacement u, the constraint b, the residual r and the search direction p of conjugate
/// gradients. Vectors have one entry of three columns (x, y, z) per corner. Corners whose diagonal
/// is below 1e-12 of the median are pinned: everything there is zero.
class Backend {
 public:
  virtual ~Backend() = default;
  virtual std::string_view name() const = 0;
  virtual uint64_t byte_count() const = 0;
  /// The machine's first failure. From then on the other calls do nothing worth reading.
  virtual Status status() const { return Status::ok(); }
  /// Does `work`: calls of this object, the same whenever `key` (≥ 0) is. A backend may record
  /// them once and replay them.
  virtual void run_recorded(int key, const std::function<void()>& work) {
    (void)key;
    work();
  }

  // The system.
  /// The matrices of all depths (section 5.2), smoothers and the coarsest factorisation. Afterwards
  /// r is wrong until recompute_residual().
  virtual void set_metric(const MetricView& metric) = 0;
  /// b = Σ_c (β−1)(α2/α1 g¹ + α1/α2 g²), the constraint of the displacement, with the metric as
  /// last set; r changes by as much.
  virtual void set_constraint(const FieldsView& fields) = 0;

  // The V-cycle.
  virtual void relax_from_zero(int depth) = 0;     ///< x = M f, M symmetric positive definite
  virtual void relax(int depth) = 0;               ///< x += Mᵀ (f − S x)
  virtual void restrict_residual(int depth) = 0;   ///< f[depth−1] = Pᵀ (f − S x)
  virtual void prolong_correction(int depth) = 0;  ///< x[depth] += P x[depth−1]
  virtual void solve_coarsest() = 0;               ///< x = S⁻¹ f
  virtual void restrict_from_zero(int depth) = 0;  ///< x = 0, f[depth−1] = Pᵀ f

  // Conjugate gradients at the finest depth; each column has its own scalars. Whatever changes r
  // leaves f = r there, and the V-cycle of the finest depth starts from it.
  virtual void recompute_residual() = 0;  ///< r = b − S u
  /// u *= a, r as follows, with the a that brings the energy lowest. Needs: r is right. Where β is
  /// one for all cells, u is β−1 times something: a slider's new value needs nothing else.
  virtual void rescale() = 0;
  virtual void update_direction(bool restart) = 0;  ///< p = x + γ p; γ = 0 on a restart
  virtual void advance() = 0;                       ///< u += a p, r −= a S p

  virtual Measures measure() const = 0;  ///< after advance()
  // What leaves the solver. Each stays as it is until the same is called again. Units: cells.
  virtual std::span<const Vec3f> displacement() = 0;         ///< u, one per corner
  virtual std::span<const Vec3f> vertex_displacement() = 0;  ///< E u, one per vertex
};

}  // namespace burnish

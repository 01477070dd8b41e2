#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "common/base/status.h"
#include "common/base/types.h"
#include "server/fields/fields_view.h"

namespace burnish {

/// Sums over the surface after one step of conjugate gradients.
struct Measures {
  double energy = 0;                   ///< ½uᵀSu − bᵀu, grid units
  double residual = 0;                 ///< ‖D^-½ r‖ / ‖D^-½ b‖, D the diagonal of S
  double preconditioned_residual = 0;  ///< rᵀz before the step; z is the V-cycle's correction of r
  double moved_max = 0;  ///< largest |E a p| at a vertex, in cells: how far the step moved it

  double curvature = 0;             ///< the least p·Sp of a column: negative if S is not definite
  double direction_energy = 0;      ///< p·Sp of all columns
  bool is_first_direction = false;  ///< p is z

  /// Returns whether u and r are numbers, as the sums have all of them, and the step went downhill
  /// by a correction that is one. At the end of a solve rounding may say otherwise.
  bool is_sound() const {
    const bool is_finite = std::isfinite(energy) && std::isfinite(residual) &&
                           std::isfinite(preconditioned_residual) && std::isfinite(moved_max);
    return is_finite && ((curvature >= 0 && !overshoots()) || residual <= kResidualOfRounding);
  }
  static constexpr double kResidualOfRounding = 1e-9;

 private:
  // rᵀz is zᵀSz if z solves for r. Where z is mostly error, the step along it is next to none, and
  // would look as if nothing was left to do.
  bool overshoots() const {
    return is_first_direction && direction_energy > kOvershootMax * preconditioned_residual;
  }
  static constexpr double kOvershootMax = 1e4;
};

/// The seam between the algorithms, written once, and the machines that run them. Every call works
/// on a whole depth. Depths run from hierarchy.coarsest to hierarchy.finest.
///
/// Each depth holds a correction x and a right-hand side f of the V-cycle. The finest depth also
/// holds the displacement u, the constraint b, the residual r and the search direction p of
/// conjugate gradients. Vectors have one entry of three columns (x, y, z) per corner. Corners with
/// next to no diagonal are pinned (pinned_below.h): all their entries are zero.
class Backend {
 public:
  virtual ~Backend() = default;
  virtual std::string_view name() const = 0;
  virtual uint64_t byte_count() const = 0;
  /// Returns the machine's first failure. After it the results of the other calls have no meaning.
  virtual Status status() const { return Status::ok(); }
  /// Does `work`, which makes calls of this object. Needs: the same calls for the same `key` (≥ 0).
  /// A backend may record the calls once and replay them.
  virtual void run_recorded(int key, const std::function<void()>& work) {
    (void)key;
    work();
  }

  // The system.
  /// Solves for the displacement of this signal instead of that of the surface's own places. Call
  /// it before the first metric. Shapes: one per corner. Units: any; results have them too.
  virtual void set_signal(std::span<const Vec3f> signal) = 0;
  /// Makes the matrices of all depths (section 5.2), the smoothers and the coarsest factorisation.
  /// If few cells have other α than before, a backend may make these cells' parts alone, with
  /// the same bits. Afterwards r is wrong until recompute_residual(). Returns whether all is new.
  virtual bool set_metric(const MetricView& metric) = 0;
  /// Forgets u and what estimates have learnt. After the next metric and constraint, results have
  /// the bits of a new backend's.
  virtual void start_over() = 0;
  /// Gives up what made a step that is not finite: sets u = 0, and until the next metric
  /// regularises the smoother so strongly that its blocks cannot fail. Afterwards r is wrong until
  /// recompute_residual().
  virtual void fall_back() = 0;
  /// Makes b = Σ_c (β−1)(α2/α1 g¹ + α1/α2 g²), the constraint of the displacement, with the last
  /// metric. Changes r by the same amount.
  virtual void set_constraint(const FieldsView& fields) = 0;

  // The V-cycle.
  virtual void relax_from_zero(int depth) = 0;     ///< x = M f, M symmetric positive definite
  virtual void relax(int depth) = 0;               ///< x += Mᵀ (f − S x)
  virtual void restrict_residual(int depth) = 0;   ///< f[depth−1] = Pᵀ (f − S x)
  virtual void prolong_correction(int depth) = 0;  ///< x[depth] += P x[depth−1]
  virtual void solve_coarsest() = 0;               ///< x = S⁻¹ f
  virtual void restrict_from_zero(int depth) = 0;  ///< x = 0, f[depth−1] = Pᵀ f

  // Conjugate gradients at the finest depth; each column has its own scalars. Each call that
  // changes r leaves f = r there. The V-cycle of the finest depth starts from it.
  virtual void recompute_residual() = 0;  ///< r = b − S u
  /// u *= a with the a of the lowest energy; r follows. Needs: r is right. If β is equal in all
  /// cells, u is proportional to β−1: a new value of the slider needs nothing else.
  virtual void rescale() = 0;
  virtual void update_direction(bool restart) = 0;  ///< p = x + γ p; γ = 0 on a restart
  virtual void advance() = 0;                       ///< u += a p, r −= a S p

  virtual Measures measure() const = 0;  ///< after advance()
  // The results. Each stays valid until the next call of the same function. Units: cells.
  virtual std::span<const Vec3f> displacement() = 0;         ///< u, one per corner
  virtual std::span<const Vec3f> vertex_displacement() = 0;  ///< E u, one per vertex
};

}  // namespace burnish

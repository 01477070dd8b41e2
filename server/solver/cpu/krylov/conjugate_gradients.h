#pragma once

#include <algorithm>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cycle/backend.h"
#include "server/solver/hierarchy/points_by_cell.h"

namespace burnish::cpu {

/// The outer iteration's matrix, vectors and steps, all in double: float32 would lose too much at
/// small α and on flat pieces.
///
/// The directions are flexible (Polak-Ribière), because the V-cycle runs in float32 and is
/// symmetric only to its rounding. z_{k+1}·(r_{k+1} − r_k) is −a z_{k+1}·q_k, so no old residual is
/// kept.
class ConjugateGradients {
 public:
  ConjugateGradients(CpuDepth& finest, const PointsByCell& points);

  ExactMatrix& matrix() { return matrix_; }
  std::vector<Double3>& constraint() { return b_; }
  std::vector<Double3>& residual() { return r_; }
  const std::vector<Double3>& displacement() const { return u_; }

  void start_over();    ///< u = b = 0, and nothing of the last step
  void forget_steps();  ///< u = 0; afterwards r is wrong
  void recompute_residual();
  void rescale();
  /// Sets f = r after a change of r from outside. The other functions keep f = r.
  void load_residual();
  void update_direction(bool restart);
  void advance();
  Measures measure() const;
  uint64_t byte_count() const;

 private:
  struct Totals {
    double energy = 0, residual = 0, constraint = 0;
    Totals& operator+=(const Totals& other) {
      energy += other.energy;
      residual += other.residual;
      constraint += other.constraint;
      return *this;
    }
  };

  Totals move_along(int32_t begin, int32_t end);
  /// Returns where the own ones end of a block of corners that ends there.
  int32_t own_end(int32_t end) const { return std::min(end, finest_.topology.own_count()); }
  template <typename Sum, typename SumBlock>
  Sum sum_over_all(SumBlock&& sum_block) const;
  template <typename Sum, typename SumBlock>
  Sum sum_over_own(SumBlock&& sum_block) const;

  CpuDepth& finest_;
  const PointsByCell& points_;
  ExactMatrix matrix_;
  std::vector<Double3> u_, b_, r_, q_;
  std::vector<Float4> p_;  // any direction will do; q = S p is exact
  Double3 z_dot_r_ = Double3::Zero();
  Double3 step_ = Double3::Zero();  // a of the last advance()
  Totals totals_;                   // after the last advance()
  double moved_max_ = 0;
  double curvature_ = 0, direction_energy_ = 0;
};

}  // namespace burnish::cpu

#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace burnish {

/// What one step of conjugate gradients tells of those to come.
struct StepSize {
  double moved_max = 0;                ///< the way of the vertex that it moved farthest
  double preconditioned_residual = 0;  ///< rᵀz, the squared error's estimate in the energy norm
};

/// How far the surface still is from the converged one, by its last steps. If each is ρ times as
/// long as the one before, those to come add up to ρ/(1 − ρ) times the last one. The steps' lengths
/// alone would say ρ badly, for they rise and fall, and the energy alone does not feel a crumb's
/// few vertices: so ρ is the larger of what both say, and never small, because the first steps do
/// what is easy.
class ConvergenceRate {
 public:
  void restart() { count_ = 0; }

  void add(const StepSize& step) { latest_[count_++ % kSteps] = step; }

  /// The largest distance of a vertex after the last step, in the unit of `moved_max`. Needs: a
  /// step since the restart.
  double distance() const { return now().moved_max * factor() / (1 - factor()); }

 private:
  const StepSize& now() const { return latest_[(count_ - 1) % kSteps]; }

  // By what a step shrinks the next one; the least before two steps are known.
  double factor() const {
    const int span = std::min(count_, kSteps) - 1;
    if (span == 0) return kFactorLeast;
    const StepSize& then = latest_[(count_ - 1 - span) % kSteps];
    const double lengths = ratio(now().moved_max, then.moved_max);
    const double squares = ratio(now().preconditioned_residual, then.preconditioned_residual);
    const double shrunk = std::max(lengths, std::sqrt(squares));
    return std::clamp(std::pow(shrunk, 1.0 / span), kFactorLeast, kFactorMost);
  }

  // Rounding may leave negative numbers where nothing is left to do.
  static double ratio(double now, double then) { return then > 0 ? std::max(now, 0.0) / then : 0; }

  static constexpr int kSteps = 3;
  static constexpr double kFactorLeast = 2.0 / 3;  // at least twice the last step is to come
  static constexpr double kFactorMost = 0.95;      // slower is rounding, which has no end

  std::array<StepSize, kSteps> latest_ = {};
  int count_ = 0;
};

}  // namespace burnish

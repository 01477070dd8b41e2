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
/// long as the one before, those to come add up to ρ/(1 − ρ) times the last one.
///
/// ρ is the larger of what the lengths and what rᵀz say: lengths rise and fall, and the energy does
/// not feel a crumb's few vertices. It is never small, because the first steps do what is easy; and
/// it is forgotten slowly, because what converges slowly shows up now and then only.
class ConvergenceRate {
 public:
  void restart() { *this = {}; }

  void add(const StepSize& step) {
    latest_[count_++ % kSteps] = step;
    const double now = std::clamp(factor_of_last_steps(), kFactorLeast, kFactorMost);
    factor_ = std::max(now, kKept * factor_ + (1 - kKept) * now);
  }

  /// The largest distance of a vertex after the last step, in the unit of `moved_max`. Needs: a
  /// step since the restart.
  double distance() const { return last().moved_max * factor_ / (1 - factor_); }

 private:
  const StepSize& last() const { return latest_[(count_ - 1) % kSteps]; }

  double factor_of_last_steps() const {
    const int span = std::min(count_, kSteps) - 1;
    if (span == 0) return kFactorLeast;
    const StepSize& then = latest_[(count_ - 1 - span) % kSteps];
    const double lengths = ratio(last().moved_max, then.moved_max);
    const double squares = ratio(last().preconditioned_residual, then.preconditioned_residual);
    return std::pow(std::max(lengths, std::sqrt(squares)), 1.0 / span);
  }

  // Rounding may leave negative numbers where nothing is left to do.
  static double ratio(double now, double then) { return then > 0 ? std::max(now, 0.0) / then : 0; }

  static constexpr int kSteps = 3;
  static constexpr double kFactorLeast = 2.0 / 3;  // at least twice the last step is to come
  static constexpr double kFactorMost = 0.95;      // slower is rounding, which has no end
  static constexpr double kKept = 0.8;             // of a slower factor, from step to step

  std::array<StepSize, kSteps> latest_ = {};
  int count_ = 0;
  double factor_ = kFactorLeast;  // ρ
};

}  // namespace burnish

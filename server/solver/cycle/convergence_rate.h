#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace burnish {

/// The facts of one step of conjugate gradients that predict later steps.
struct StepSize {
  double moved_max = 0;                ///< the largest move of a vertex
  double preconditioned_residual = 0;  ///< rᵀz, an estimate of the squared error in the energy norm
};

/// Estimates from the last steps how far the surface still is from the converged one. If each step
/// is ρ times as long as the one before, all later steps add up to ρ/(1 − ρ) times the last one.
///
/// Two ratios estimate ρ, and the larger one counts: of the lengths, which rise and fall, and of
/// rᵀz, which hardly depends on a small component's few vertices. ρ never becomes small, because
/// the first steps do what is easy. ρ falls slowly, because slow parts show up only now and then.
class ConvergenceRate {
 public:
  void restart() { *this = {}; }

  void add(const StepSize& step) {
    latest_[count_++ % kSteps] = step;
    const double now = std::clamp(factor_of_last_steps(), kFactorLeast, kFactorMost);
    factor_ = std::max(now, kKept * factor_ + (1 - kKept) * now);
  }

  /// Returns the largest distance of a vertex after the last step, in the unit of `moved_max`.
  /// Needs: a step since the restart.
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

  // At the end of a solve rounding may leave negative numbers.
  static double ratio(double now, double then) { return then > 0 ? std::max(now, 0.0) / then : 0; }

  static constexpr int kSteps = 3;
  static constexpr double kFactorLeast = 2.0 / 3;  // at least twice the last step is left
  static constexpr double kFactorMost = 0.95;      // a larger factor is rounding, which never ends
  static constexpr double kKept = 0.8;  // part of the last factor that stays after a faster step

  std::array<StepSize, kSteps> latest_ = {};
  int count_ = 0;
  double factor_ = kFactorLeast;  // ρ
};

}  // namespace burnish

#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace burnish {

/// By what factor a step reduces the error, from the preconditioned residuals rᵀz of the last
/// steps, which estimate the squared error in the energy norm; and from it how much is still to
/// come. Conjugate gradients reduce by ρ = (√κ − 1)/(√κ + 1), κ the condition number, and the
/// V-cycle corrects of the slowest error no more than its κ-th part: slow modes hide behind small
/// corrections.
class ConvergenceRate {
 public:
  void restart() { count_ = 0; }

  void add(double preconditioned_residual) { latest_[count_++ % kSteps] = preconditioned_residual; }

  /// The largest error over the V-cycle's correction of it, at least 1.
  double error_over_correction() const {
    const double root = (1 + factor()) / (1 - factor());
    return root * root;
  }

 private:
  // In [0, kFactorMax]; a cautious guess before enough steps are known.
  double factor() const {
    if (count_ < kStepsLeast) return kFactorGuess;
    const int span = std::min(count_, kSteps) - 1;
    const double now = latest_[(count_ - 1) % kSteps];
    const double then = latest_[(count_ - 1 - span) % kSteps];
    if (!(then > 0)) return 0;  // nothing was left to do
    return std::clamp(std::pow(std::max(now, 0.0) / then, 0.5 / span), 0.0, kFactorMax);
  }

  static constexpr int kSteps = 9;
  static constexpr int kStepsLeast = 3;
  static constexpr double kFactorGuess = 0.5;
  static constexpr double kFactorMax = 0.9;  // κ = 361: slower is noise that no vertex sees

  std::array<double, kSteps> latest_ = {};
  int count_ = 0;
};

}  // namespace burnish

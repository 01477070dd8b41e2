#pragma once

#include <memory>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cpu/krylov/conjugate_gradients.h"
#include "server/solver/cpu/products/coarsest.h"
#include "server/solver/cpu/smoothers/smoother.h"
#include "server/solver/solver.h"
#include "tests/bench/input.h"

namespace burnish {

/// What follows a restriction: one cycle of the coarser depth, or two, the second from where the
/// first ended.
enum class CycleShape { kV = 1, kW = 2 };

/// The stand-alone solver of section 7.1 from the CPU backend's parts: any number of Gauss-Seidel
/// sweeps at each depth, W-cycles or V-cycles. Outside of any session, from a zero solution.
class SweepSolver {
 public:
  SweepSolver(const BenchSystem& system, const FieldsView& fields, const cpu::SliceOptions& sweeps);

  /// W: u += a x with the best length a, where the paper's a is 1. V: conjugate gradients, as the
  /// product does.
  void iterate(CycleShape shape);

  /// ‖b − S u‖ / ‖b‖, diagonally scaled, in double.
  double residual() const { return outer_->measure().residual; }

 private:
  void cycle(size_t depth, CycleShape shape, bool from_zero);

  std::vector<cpu::CpuDepth> depths_;                           // from the coarsest
  std::vector<std::unique_ptr<cpu::DepthSmoother>> smoothers_;  // none at the coarsest
  cpu::CoarsestSolver coarsest_;
  std::unique_ptr<cpu::ConjugateGradients> outer_;
  bool first_ = true;
};

}  // namespace burnish

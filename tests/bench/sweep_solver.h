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

/// How many cycles of the coarser depth follow a restriction: one, or two, the second from the
/// first one's result.
enum class CycleShape { kV = 1, kW = 2 };

/// The stand-alone solver of section 7.1 from the CPU backend's parts: any number of Gauss-Seidel
/// sweeps at each depth, W-cycles or V-cycles. It needs no session and starts from a zero solution.
class SweepSolver {
 public:
  SweepSolver(const BenchSystem& system, const FieldsView& fields, const cpu::SliceOptions& sweeps);

  /// W: u += a x with the best length a; the paper's a is 1. V: conjugate gradients, like the
  /// product.
  void iterate(CycleShape shape);

  /// Returns ‖b − S u‖ / ‖b‖, diagonally scaled, in double.
  double residual() const { return outer_->measure().residual; }

 private:
  void cycle(size_t depth, CycleShape shape, bool from_zero);

  std::vector<cpu::CpuDepth> depths_;                           // the coarsest first
  std::vector<std::unique_ptr<cpu::DepthSmoother>> smoothers_;  // none at the coarsest
  cpu::CoarsestSolver coarsest_;
  std::unique_ptr<cpu::ConjugateGradients> outer_;
  bool first_ = true;
};

}  // namespace burnish

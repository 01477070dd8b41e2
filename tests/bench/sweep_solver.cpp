#include "tests/bench/sweep_solver.h"

#include "server/solver/cpu/assembly/assembly.h"
#include "server/solver/cpu/assembly/constraint.h"
#include "server/solver/cpu/products/products.h"
#include "server/solver/cpu/products/transfer.h"

namespace burnish {

SweepSolver::SweepSolver(const BenchSystem& system, const FieldsView& fields,
                         const cpu::SliceOptions& sweeps) {
  const PreparedMesh& prepared = *system.prepared;
  depths_.reserve(system.hierarchy->depths.size());
  for (const HierarchyDepth& topology : system.hierarchy->depths) {
    depths_.emplace_back(topology);
    const bool coarsest = depths_.size() == 1;
    smoothers_.push_back(coarsest ? nullptr : cpu::make_slices(topology, sweeps));
  }
  outer_ = std::make_unique<cpu::ConjugateGradients>(depths_.back(), system.hierarchy->points);

  CellAlphas alphas;
  evaluate(fields.metric, prepared, alphas);
  cpu::assemble(prepared, alphas, depths_, &outer_->matrix());
  for (size_t i = 1; i < depths_.size(); ++i) smoothers_[i]->set_up(depths_[i]);
  coarsest_.factor(depths_.front());
  cpu::Constraint constraint(prepared, depths_.back());
  constraint.set_ratio(cpu::ratios_of(alphas));
  constraint.assemble(fields, outer_->constraint(), outer_->residual());
  outer_->recompute_residual();
}

void SweepSolver::iterate(CycleShape shape) {
  cycle(depths_.size() - 1, shape, true);
  outer_->update_direction(first_ || shape == CycleShape::kW);
  outer_->advance();
  first_ = false;
}

void SweepSolver::cycle(size_t depth, CycleShape shape, bool from_zero) {
  if (depth == 0) return coarsest_.solve(depths_.front());
  cpu::CpuDepth& fine = depths_[depth];
  if (from_zero)
    smoothers_[depth]->relax_from_zero(fine);
  else
    smoothers_[depth]->relax(fine);
  cpu::compute_residual(fine);
  cpu::restrict_to_coarse(fine, fine.r, depths_[depth - 1]);
  const int visits = depth == 1 ? 1 : static_cast<int>(shape);  // a direct solve needs one
  for (int visit = 0; visit < visits; ++visit) cycle(depth - 1, shape, visit == 0);
  cpu::add_prolonged(depths_[depth - 1], fine);
  smoothers_[depth]->relax(fine);
}

}  // namespace burnish

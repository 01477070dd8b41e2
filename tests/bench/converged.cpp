#include "tests/bench/converged.h"

#include <cmath>

#include "tests/bench/report.h"

namespace burnish {

static constexpr double kDistance = 1e-11;
static constexpr double kResidualMax = 1e-7;
static constexpr int kCyclesMax = 1000;

static VertexDistance distance_between(std::span<const Vec3d> a, std::span<const Vec3d> b,
                                       double diagonal) {
  double most = 0, sum = 0;
#pragma omp parallel for schedule(static) reduction(max : most) reduction(+ : sum)
  for (size_t v = 0; v < a.size(); ++v) {
    const double square = (a[v] - b[v]).squaredNorm();
    most = std::max(most, square);
    sum += square;
  }
  return {std::sqrt(most) / diagonal, std::sqrt(sum / static_cast<double>(a.size())) / diagonal};
}

Result<Converged> Converged::solve(const BenchSystem& system, const FieldsView& fields) {
  ASSIGN_OR_RETURN(const auto solver, Solver::create(system, {.backend = BackendKind::kCpu}));
  solver->set_metric(fields);
  ASSIGN_OR_RETURN(const SolveReport solved, solver->solve(kDistance, kCyclesMax));
  solver->set_metric(fields);  // the next step starts from a newly computed residual
  const StepReport last = solver->step();
  if (!solved.converged || !(last.residual <= kResidualMax))
    return failed_precondition(
        system.name + " has not converged after " + std::to_string(solved.cycles) +
        " cycles: residual " + in_words("%.1e", last.residual) + ", the limit is " +
        in_words("%.1e", kResidualMax) + "; distance " + in_words("%.1e", solved.last.distance) +
        ", the limit is " + in_words("%.1e", kDistance));
  Converged converged{.vertices = solver->evaluate_vertices(),
                      .diagonal = system.prepared->statistics.diagonal(),
                      .cycles = solved.cycles,
                      .residual = last.residual,
                      .correction = last.distance};
  converged.moved_max =
      distance_between(converged.vertices, system.prepared->vertices, converged.diagonal).max;
  return converged;
}

VertexDistance Converged::distance(const Solver& solver) const {
  return distance_between(solver.evaluate_vertices(), vertices, diagonal);
}

}  // namespace burnish

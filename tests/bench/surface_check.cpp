#include "tests/bench/surface_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "server/fields/fields.h"
#include "tests/bench/report.h"

namespace burnish {

// Over the diagonal.
static constexpr double kSolvedDistance = 3e-8;
static constexpr double kApartMax = 1e-6;

static constexpr int kCyclesMax = 500;

Status SurfaceCheck::begin(Solver& solver) {
  ASSIGN_OR_RETURN(of_first_run_, solve(solver));
  if (of_first_solver_.empty()) of_first_solver_ = of_first_run_;
  return Status::ok();
}

Status SurfaceCheck::end(Solver& solver) {
  ASSIGN_OR_RETURN(const Surface again, solve(solver));
  const bool is_same = again == of_first_run_;
  const double apart = between(again, of_first_solver_);
  std::printf("  surface: %s; from the first one's: %.1e of the diagonal, at most %.0e wanted\n",
              is_same ? "two runs gave the same bits" : "TWO RUNS DIFFER", apart, kApartMax);
  if (!is_same) return internal_error("two runs gave different bits");
  if (apart <= kApartMax) return Status::ok();
  return internal_error("surfaces are " + in_words("%.1e", apart) +
                        " of the diagonal apart, the limit is " + in_words("%.0e", kApartMax));
}

Result<SurfaceCheck::Surface> SurfaceCheck::solve(Solver& solver) const {
  Fields fields(*system_.prepared);
  fields.set_transfer_curve(TransferCurve(25));
  fields.set_gradient_scale(0.4);
  solver.start_over(fields.view());
  ASSIGN_OR_RETURN(const SolveReport report, solver.solve(kSolvedDistance, kCyclesMax));
  std::printf("  solved: %d cycles in %.2f s, distance %.1e\n", report.cycles, report.solve_seconds,
              report.last.distance);
  const auto moved = solver.vertex_displacement();
  return Surface(moved.begin(), moved.end());
}

// Returns the largest distance of a vertex over the diagonal; infinity if one is nowhere.
double SurfaceCheck::between(const Surface& one, const Surface& other) const {
  double most = 0;
  for (size_t v = 0; v < one.size(); ++v) {
    const double apart = (one[v] - other[v]).norm();
    if (!std::isfinite(apart)) return std::numeric_limits<double>::infinity();
    most = std::max(most, apart);
  }
  return most * system_.prepared->frame.cell_size / system_.prepared->statistics.diagonal();
}

}  // namespace burnish

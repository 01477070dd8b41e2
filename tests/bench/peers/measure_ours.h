#pragma once

#include <span>

#include "common/mesh/triangle_mesh.h"
#include "server/solver/cycle/multigrid.h"
#include "server/solver/solver.h"
#include "tests/bench/peers/row.h"

namespace burnish::bench {

struct PreparedScan : Multigrid {
  PrepareReport report;
  double setup_ms = 0;  ///< for both
};

Result<PreparedScan> prepare_scan(const TriangleMesh& mesh, int depth);

/// Times the product on one backend at every α, settling by its own estimate. Errors are to
/// `answers` of a direct solver on the grid's system. If these lack an α, errors are to the
/// product's own converged answer. The notes say how far that is from the former.
Result<std::vector<Row>> measure_ours(const PreparedScan& scan, BackendKind backend,
                                      std::span<const double> alphas, const Answers& answers);

}  // namespace burnish::bench

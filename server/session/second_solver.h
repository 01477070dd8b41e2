#pragma once

#include <memory>

#include "server/solver/solver.h"

namespace burnish {

/// Makes a solver beside a session's own, for its bands or colours. A device that is full leaves
/// the work to the processors, which need longer. Fails: as Solver::create().
Result<std::unique_ptr<Solver>> make_second_solver(const Multigrid& on,
                                                   const SolverOptions& options);

}  // namespace burnish

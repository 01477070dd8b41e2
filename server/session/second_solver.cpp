#include "server/session/second_solver.h"

namespace burnish {

Result<std::unique_ptr<Solver>> make_second_solver(const Multigrid& on,
                                                   const SolverOptions& options) {
  auto made = Solver::create(on, options);
  const bool is_full = made.status().code() == StatusCode::kResourceExhausted;
  if (!is_full || options.backend == BackendKind::kCpu) return made;
  SolverOptions on_processors = options;
  on_processors.backend = BackendKind::kCpu;
  return Solver::create(on, on_processors);
}

}  // namespace burnish

// Prints one line per backend: medians of the solver's calls on a generated scan.
// Usage: solver_times KIND VERTICES DEPTH [cpu|cuda]...

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "common/mesh/generate.h"
#include "server/prepare/prepare.h"
#include "server/solver/fields.h"
#include "server/solver/hierarchy.h"
#include "server/solver/solver.h"

namespace burnish {
namespace {

struct Input {
  std::shared_ptr<const PreparedMesh> prepared;
  std::shared_ptr<const Hierarchy> hierarchy;
};

double median_ms(int repeats, const std::function<void(int)>& work) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  for (int i = 0; i < repeats + 2; ++i) {  // the first two warm up
    const auto start = Clock::now();
    work(i);
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  times.erase(times.begin(), times.begin() + 2);
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[repeats / 2];
}

Status print_times(const Input& input, BackendKind backend) {
  ASSIGN_OR_RETURN(auto solver,
                   Solver::create(input.prepared, input.hierarchy, {.backend = backend}));
  Fields fields(*input.prepared);
  fields.set_transfer_curve(TransferCurve(20));
  fields.set_gradient_scale(0.3);
  const int repeats = backend == BackendKind::kCpu ? 3 : 20;
  const double matrix = median_ms(repeats, [&](int) { solver->set_metric(fields.view()); });
  const double constraint =
      median_ms(repeats, [&](int) { solver->set_gradient_scale(fields.view()); });
  StepReport last;
  const double step = median_ms(5 * repeats, [&](int) { last = solver->step(); });
  RETURN_IF_ERROR(solver->status());
  const auto& grid = input.hierarchy->at(input.hierarchy->finest).grid;
  std::printf(
      "%-5s depth %2d..%d  n %8d  step %8.3f ms  matrix+rhs %9.3f ms  rhs %8.3f ms  "
      "%6.0f bytes/corner  distance %.1e after %d\n",
      std::string(solver->backend_name()).c_str(), input.hierarchy->coarsest,
      input.hierarchy->finest, grid.corner_count(), step, matrix, constraint,
      static_cast<double>(solver->byte_count()) / grid.corner_count(), last.distance, last.cycle);
  return Status::ok();
}

Status run(const std::string& kind, uint64_t vertices, int depth, std::span<char*> backends) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, generate_scan({.kind = kind, .vertices = vertices}));
  Input input;
  ASSIGN_OR_RETURN(input.prepared, prepare(mesh, {.depth = depth}));
  input.hierarchy = make_hierarchy(*input.prepared);
  for (const std::string_view backend : backends)
    RETURN_IF_ERROR(print_times(input, backend == "cpu" ? BackendKind::kCpu : BackendKind::kCuda));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  if (argc < 5) {
    std::cerr << "usage: solver_times KIND VERTICES DEPTH [cpu|cuda]...\n";
    return 2;
  }
  const auto status = burnish::run(argv[1], std::strtoull(argv[2], nullptr, 10), std::atoi(argv[3]),
                                   {argv + 4, static_cast<size_t>(argc - 4)});
  if (status.is_ok()) return 0;
  std::cerr << "solver_times: " << status.message() << "\n";
  return 1;
}

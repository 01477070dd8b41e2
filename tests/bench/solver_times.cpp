// Prints one line per backend and smoother: medians of the solver's calls.
// Usage: solver_times SCAN[@DEPTH] cpu|cuda[/SHARDS][:SMOOTHER]...
// SCAN: a mesh file or KIND:VERTICES. Shards go to the devices in turn.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <span>

#include "server/fields/fields.h"
#include "server/solver/solver.h"
#include "tests/bench/input.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr double kCornersMax = 1.2e8;

// "cuda:gauss-seidel", "cuda/2"
Result<SolverOptions> parse_options(std::string_view text) {
  const std::string_view place = text.substr(0, text.find(':'));
  const std::string_view backend = place.substr(0, place.find('/'));
  if (backend != "cpu" && backend != "cuda")
    return invalid_argument("backend '" + std::string(backend) + "' is neither cpu nor cuda");
  SolverOptions options{.backend = backend == "cpu" ? BackendKind::kCpu : BackendKind::kCuda};
  options.devices = 1;
  if (backend.size() < place.size()) {
    const std::string_view shards = place.substr(backend.size() + 1);
    const char* const end = shards.data() + shards.size();
    if (std::from_chars(shards.data(), end, options.devices).ptr != end || options.devices < 1)
      return invalid_argument("'" + std::string(shards) + "' is not a number of shards");
  }
  if (place.size() == text.size()) return options;
  const std::string_view smoother = text.substr(place.size() + 1);
  const auto named = std::ranges::find(kSmoothers, smoother, &NamedSmoother::name);
  if (named == std::end(kSmoothers))
    return invalid_argument("unknown smoother '" + std::string(smoother) + "'");
  options.smoother = named->smoother;
  return options;
}

Status print_times(const BenchSystem& system, const SolverOptions& options) {
  ASSIGN_OR_RETURN(auto solver, Solver::create(system, options));
  Fields fields(*system.prepared);
  fields.set_transfer_curve(TransferCurve(20));
  fields.set_gradient_scale(0.3);
  const int repeats = options.backend == BackendKind::kCpu ? 3 : 20;
  // Other fields each time: a backend may skip unchanged fields.
  Fields others = fields;
  others.set_transfer_curve(TransferCurve(20.1));
  others.set_gradient_scale(0.31);
  FieldsView now = fields.view(), next = others.view();
  const double matrix = median_milliseconds(repeats, 2, [&] {
    std::swap(now, next);
    solver->set_metric(now);
  });
  const double constraint = median_milliseconds(repeats, 2, [&] {
    std::swap(now, next);
    solver->set_gradient_scale(now);
  });
  StepReport last;
  const double step = median_milliseconds(5 * repeats, 2, [&] { last = solver->step(); });
  RETURN_IF_ERROR(solver->status());
  std::printf(
      "%-5s x%d %-13s depth %2d..%d  n %8d  step %8.3f ms  matrix+rhs %9.3f ms  rhs %8.3f ms  "
      "%6.0f bytes/corner  distance %.1e after %d\n",
      std::string(solver->backend_name()).c_str(), options.devices,
      std::string(name_of(options.smoother)).c_str(), system.hierarchy->coarsest, system.depth(),
      system.corners(), step, matrix, constraint,
      static_cast<double>(solver->byte_count()) / system.corners(), last.distance, last.cycle);
  return Status::ok();
}

Status run(const char* name, std::span<char*> backends) {
  ASSIGN_OR_RETURN(const ScanArgument scan, parse_scan(name));
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  ASSIGN_OR_RETURN(const BenchSystem system,
                   make_system(scan, mesh, depth_of(scan, mesh), kCornersMax));
  for (const char* backend : backends) {
    ASSIGN_OR_RETURN(const SolverOptions options, parse_options(backend));
    RETURN_IF_ERROR(print_times(system, options));
  }
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: solver_times SCAN[@DEPTH] cpu|cuda[/SHARDS][:SMOOTHER]...\n";
    return 2;
  }
  const auto status = burnish::run(argv[1], {argv + 2, static_cast<size_t>(argc - 2)});
  if (status.is_ok()) return 0;
  std::cerr << "solver_times: " << status.message() << "\n";
  return 1;
}

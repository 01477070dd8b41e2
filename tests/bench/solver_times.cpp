// Prints one line per backend and smoother: medians of the solver's calls.
// Usage: solver_times [--surface] SCAN[@DEPTH] cpu|cuda[/SHARDS][:SMOOTHER]...
// SCAN: a mesh file or KIND:VERTICES. Shards go to the devices in turn.
// --surface: also solves before and after the timed calls. Both must end with the same bits, and
// where the first backend did.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <span>

#include "server/fields/fields.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/multi/device_need.h"
#include "server/solver/solver.h"
#include "tests/bench/input.h"
#include "tests/bench/surface_check.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

// Above what is measured. Noise adds to the area, from which the number is expected, but no
// corners.
constexpr double kCornersMax = 2e8;

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

Status print_times(const BenchSystem& system, const SolverOptions& options, Solver& solver) {
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
    solver.set_metric(now);
  });
  const double constraint = median_milliseconds(repeats, 2, [&] {
    std::swap(now, next);
    solver.set_gradient_scale(now);
  });
  StepReport last;
  const double step = median_milliseconds(5 * repeats, 2, [&] { last = solver.step(); });
  RETURN_IF_ERROR(solver.status());
  std::printf(
      "%-5s x%d %-13s depth %2d..%d  n %8d  step %8.3f ms  matrix+rhs %9.3f ms  rhs %8.3f ms  "
      "%6.0f bytes/corner  distance %.1e after %d\n",
      std::string(solver.backend_name()).c_str(), options.devices,
      std::string(name_of(options.smoother)).c_str(), system.hierarchy->coarsest, system.depth(),
      system.corners(), step, matrix, constraint,
      static_cast<double>(solver.byte_count()) / system.corners(), last.distance, last.cycle);
  return Status::ok();
}

// Finds out before the scan is cut and copied: that takes minutes.
Status check_room(const BenchSystem& system, const SolverOptions& options) {
  if (options.backend == BackendKind::kCpu || !cuda_device().is_ok()) return Status::ok();
  const int needed = shards_that_fit(predict_device_bytes(system), cuda_memory_max());
  if (options.devices >= needed) return Status::ok();
  return resource_exhausted(system.name + " needs " + std::to_string(needed) + " devices");
}

Status measure(const BenchSystem& system, const SolverOptions& options, SurfaceCheck* check) {
  RETURN_IF_ERROR(check_room(system, options));
  Result<std::unique_ptr<Solver>> made = internal_error("no solver yet");
  const double seconds = 1e-3 * milliseconds([&] { made = Solver::create(system, options); });
  ASSIGN_OR_RETURN(const auto solver, std::move(made));
  if (check != nullptr) RETURN_IF_ERROR(check->begin(*solver));
  RETURN_IF_ERROR(print_times(system, options, *solver));
  if (check == nullptr) return Status::ok();
  std::printf("  made in %.0f s\n", seconds);
  return check->end(*solver);
}

Result<BenchSystem> prepared(const char* name) {
  ASSIGN_OR_RETURN(const ScanArgument scan, parse_scan(name));
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  return make_system(scan, mesh, depth_of(scan, mesh), kCornersMax);
}

// Goes on after a backend that fails, and fails at the end.
Status run(const char* name, std::span<char*> backends, bool surface) {
  Result<BenchSystem> made = internal_error("no scan yet");
  const double seconds = 1e-3 * milliseconds([&] { made = prepared(name); });
  ASSIGN_OR_RETURN(const BenchSystem system, std::move(made));
  if (surface) std::printf("%s prepared in %.0f s\n", system.name.c_str(), seconds);
  SurfaceCheck check(system);
  Status all;
  for (const char* backend : backends) {
    ASSIGN_OR_RETURN(const SolverOptions options, parse_options(backend));
    const Status one = measure(system, options, surface ? &check : nullptr);
    if (one.is_ok()) continue;
    all = one.with_context(backend);
    std::printf("  failed: %s\n", all.message().c_str());
  }
  return all;
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  std::span<char*> words(argv + 1, static_cast<size_t>(argc - 1));
  const bool surface = !words.empty() && words[0] == std::string_view("--surface");
  if (surface) words = words.subspan(1);
  if (words.size() < 2) {
    std::cerr << "usage: solver_times [--surface] SCAN[@DEPTH] cpu|cuda[/SHARDS][:SMOOTHER]...\n";
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // a run that is cut short keeps its lines
  const auto status = burnish::run(words[0], words.subspan(1), surface);
  if (status.is_ok()) return 0;
  std::cerr << "solver_times: " << status.message() << "\n";
  return 1;
}

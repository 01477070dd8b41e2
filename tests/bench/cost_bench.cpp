// Measures the cost of a step, a new constraint and a new matrix by the number of corners. Compares
// it with the time of memory alone at the bandwidth of the same run.

#include "common/base/parallel.h"
#include "server/fields/fields.h"
#include "server/solver/solver.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/memory_floor.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr int kRepeats = 7;

std::vector<BenchTable::Column> columns() {
  return {{"scan", "", 18},
          {"corners", "%.0f", 9},
          {"threads", "%.0f"},
          {"step_ms", "%.2f"},
          {"rhs_ms", "%.2f"},
          {"matrix_ms", "%.2f"},
          {"step_floor_ms", "%.2f"},
          {"rhs_floor_ms", "%.2f"},
          {"matrix_floor_ms", "%.2f"},
          {"step_ratio", "%.2f"},
          {"rhs_ratio", "%.2f"},
          {"matrix_ratio", "%.2f"},
          {"step_bytes_per_corner", "%.0f"}};
}

Status report_threads(const BenchSystem& system, int threads, const BenchReport& report,
                      BenchTable& table) {
  ASSIGN_OR_RETURN(const auto solver,
                   Solver::create(system, {.backend = BackendKind::kCpu, .threads = threads}));
  Fields fields(*system.prepared);
  fields.set_gradient_scale(0);
  const double matrix =
      median_milliseconds(kRepeats, 1, [&] { solver->set_metric(fields.view()); });
  double beta = 0;
  const double rhs = median_milliseconds(kRepeats, 1, [&] {
    fields.set_gradient_scale(beta += 0.01);
    solver->set_gradient_scale(fields.view());
  });
  const double step = median_milliseconds(kRepeats, 1, [&] { solver->step(); });
  const MemoryFloor floor = memory_floor(system);
  const double per_ms = triad_of(report, threads) * 1e6;  // bytes
  table.add({system.name, static_cast<double>(system.corners()), static_cast<double>(threads), step,
             rhs, matrix, floor.step / per_ms, floor.rhs / per_ms, floor.matrix / per_ms,
             step * per_ms / floor.step, rhs * per_ms / floor.rhs, matrix * per_ms / floor.matrix,
             floor.step / system.corners()});
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& table = report.add_table("cost", columns());
  for (const ScanArgument& scan : arguments.scans) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    use_threads(arguments.threads);
    ASSIGN_OR_RETURN(const auto system,
                     system_or_remark(scan, mesh, depth_of(scan, mesh), arguments, report));
    if (!system) continue;
    for (int threads : thread_counts(arguments))
      RETURN_IF_ERROR(report_threads(*system, threads, report, table));
  }
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"cost_bench",
                              {"blob:4000@5", "blob:16000@6", "blob:60000@7", "blob:250000@8",
                               "blob:1000000@9", "blob:4000000@10"},
                              burnish::run},
                             argc, argv);
}

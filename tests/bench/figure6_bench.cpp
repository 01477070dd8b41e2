// Figure 6: time and accuracy by number of cycles with five Gauss-Seidel sweeps at each depth, for
// systems of three depths: serial, parallel, and parallel with temporal blocking.

#include "common/base/parallel.h"
#include "server/fields/fields.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/sweep_solver.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr int kDepths = 3;  // the scan's and the coarser ones
constexpr int kSweeps = 5;
constexpr int kCycles = 8;

struct Mode {
  const char* name;
  int threads;
  bool temporal_blocking;
};

void report_mode(const std::string& mesh, const BenchSystem& system, const FieldsView& fields,
                 const Mode& mode, CycleShape shape, BenchTable& table) {
  use_threads(mode.threads);
  SweepSolver solver(
      system, fields,
      {.sweeps = kSweeps, .blocks = mode.threads, .temporal_blocking = mode.temporal_blocking});
  double time = 0;
  for (int cycle = 1; cycle <= kCycles; ++cycle) {
    time += milliseconds([&] { solver.iterate(shape); });
    table.add({mesh, system.name, static_cast<double>(system.corners()),
               shape == CycleShape::kV ? "V" : "W", mode.name, static_cast<double>(cycle), time,
               solver.residual()});
  }
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& table = report.add_table("figure6", {{"mesh", "", 16},
                                                   {"scan", "", 18},
                                                   {"corners", "%.0f"},
                                                   {"shape"},
                                                   {"mode", "", 18},
                                                   {"cycle", "%.0f"},
                                                   {"time_ms", "%.1f"},
                                                   {"residual", "%.2e", 9}});
  const Mode modes[] = {{"serial", 1, false},
                        {"parallel", arguments.threads, false},
                        {"parallel-blocked", arguments.threads, true}};
  for (const ScanArgument& scan : arguments.scans) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    const int finest = depth_of(scan, mesh);
    for (int depth = std::max(kDepthMin, finest - kDepths + 1); depth <= finest; ++depth) {
      use_threads(arguments.threads);
      ASSIGN_OR_RETURN(const auto system, system_or_remark(scan, mesh, depth, arguments, report));
      if (!system) continue;
      Fields fields(*system->prepared);
      fields.set_gradient_scale(0);
      for (const CycleShape shape : {CycleShape::kW, CycleShape::kV})
        for (const Mode& mode : modes)
          report_mode(scan.name(), *system, fields.view(), mode, shape, table);
    }
  }
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"figure6_bench", {"tablet:1000000@9"}, burnish::run}, argc, argv);
}

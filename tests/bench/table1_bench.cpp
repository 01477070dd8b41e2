// Table 1: the paper's frames per second in the three states of the system, next to the product's
// on either backend, with the speed-up of all threads over one and of CUDA over all threads. A scan
// without a depth is measured at depth 8, the paper's, and at 9.

#include "server/solver/cuda/cuda_backend.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/frames.h"

namespace burnish {
namespace {

constexpr int kDepths[] = {8, 9};

/// A row of the paper, on a desktop with the four cores of a Core i7 920; its GPU evaluates the
/// vertices.
struct PaperRow {
  const char* scan;
  double vertices, corners;
  double solve_fps, rhs_fps, matrix_fps;
  double speed_up;  ///< by threads and temporal blocking
};

constexpr PaperRow kPaper[] = {
    {"Lucy", 2.6e5, 1.5e5, 40, 20, 8, 2.7},      {"Buddha", 5.4e5, 2.1e5, 31, 15, 6, 2.6},
    {"Armadillo", 1.7e5, 2.6e5, 30, 13, 5, 3.3}, {"Dragon", 4.4e5, 2.7e5, 27, 12, 5, 3.0},
    {"Isidore", 1.1e6, 2.8e5, 27, 12, 4, 3.0},   {"Forma", 1.0e6, 3.2e5, 24, 11, 4, 3.0},
    {"David", 2.0e6, 4.2e5, 20, 9, 3, 3.3}};

std::vector<BenchTable::Column> columns() {
  return {{"scan", "", 26},        {"on", "", 5},          {"threads", "%.0f"},
          {"vertices", "%.0f", 9}, {"corners", "%.0f", 9}, {"solve_fps", "%.1f"},
          {"rhs_fps", "%.1f"},     {"matrix_fps", "%.1f"}, {"speed_up", "%.1f"}};
}

void add_paper(BenchTable& table) {
  for (const PaperRow& row : kPaper)
    table.add({row.scan, "paper", 4.0, row.vertices, row.corners, row.solve_fps, row.rhs_fps,
               row.matrix_fps, row.speed_up});
}

Result<FrameTimes> measure(const BenchSystem& system, BackendKind backend, int threads) {
  ASSIGN_OR_RETURN(const auto session,
                   Session::open(system, {.backend = backend, .threads = threads}));
  const FrameTimes times = measure_frames(*session, TransferCurve(kAlphaDefault));
  RETURN_IF_ERROR(session->solver().status());
  return times;
}

Status report_system(const BenchSystem& system, int threads, BenchTable& table) {
  const auto add = [&](const char* on, const FrameTimes& times, const FrameTimes& slower) {
    table.add({system.name, on, static_cast<double>(threads),
               static_cast<double>(system.prepared->vertices.size()),
               static_cast<double>(system.corners()), 1000 / times.solve, 1000 / times.rhs,
               1000 / times.matrix, slower.solve / times.solve});
  };
  ASSIGN_OR_RETURN(const FrameTimes serial, measure(system, BackendKind::kCpu, 1));
  ASSIGN_OR_RETURN(const FrameTimes on_cpu, measure(system, BackendKind::kCpu, threads));
  add("cpu", on_cpu, serial);
  if (!cuda_device().is_ok()) return Status::ok();
  ASSIGN_OR_RETURN(const FrameTimes on_cuda, measure(system, BackendKind::kCuda, threads));
  add("cuda", on_cuda, on_cpu);
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& table = report.add_table("table1", columns());
  add_paper(table);
  for (const ScanArgument& scan : arguments.scans) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    for (const int depth : kDepths) {
      if (scan.depth != 0 && depth != kDepths[0]) break;
      ASSIGN_OR_RETURN(
          const auto system,
          system_or_remark(scan, mesh, scan.depth != 0 ? scan.depth : depth, arguments, report));
      if (system) RETURN_IF_ERROR(report_system(*system, arguments.threads, table));
    }
  }
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"table1_bench", {"tablet:1000000", "blob:250000"}, burnish::run},
                             argc, argv);
}

// Figure 7 and Table 1: frames per second in the three states of the system, at three depths, by
// smoother, by threads, and by where the vertices are evaluated. Speed-up: of all threads over one,
// and of CUDA, where there is a device, over all threads.

#include "common/base/parallel.h"
#include "server/solver/cuda/cuda_backend.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/frames.h"

namespace burnish {
namespace {

constexpr int kDepths = 3;  // the scan's and the coarser ones

double per_second(double milliseconds) {
  return 1000 / milliseconds;
}

std::vector<BenchTable::Column> ablation_columns() {
  return {{"mesh", "", 16},
          {"scan", "", 18},
          {"vertices", "%.0f"},
          {"corners", "%.0f"},
          {"smoother", "", 18},
          {"threads", "%.0f"},
          {"solve_ms", "%.1f"},
          {"rhs_ms", "%.1f"},
          {"matrix_ms", "%.1f"},
          {"evaluate_ms", "%.1f"},
          {"solve_fps", "%.1f"},
          {"rhs_fps", "%.1f"},
          {"matrix_fps", "%.1f"},
          {"solve_evaluate_fps", "%.1f"},
          {"rhs_evaluate_fps", "%.1f"},
          {"matrix_evaluate_fps", "%.1f"}};
}

Result<FrameTimes> times_of(const BenchSystem& system, BackendKind backend, Smoother smoother,
                            int threads) {
  const SolverOptions options{.backend = backend, .smoother = smoother, .threads = threads};
  ASSIGN_OR_RETURN(const auto session, Session::open(system.prepared, system.hierarchy, options));
  use_threads(threads);
  return measure_frames(*session, TransferCurve(kAlphaDefault));
}

Status report_system(const std::string& mesh, const BenchSystem& system,
                     const BenchArguments& arguments, BenchTable& ablation, BenchTable& table_1) {
  const double vertices = static_cast<double>(system.prepared->vertices.size());
  const double corners = system.corners();
  const auto add_to_table_1 = [&](const char* backend, const FrameTimes& times, double speed_up) {
    table_1.add({system.name, backend, vertices, corners, per_second(times.solve),
                 per_second(times.rhs), per_second(times.matrix), speed_up});
  };
  FrameTimes on_cpu;
  for (const NamedSmoother& named : kSmoothers) {
    FrameTimes one_thread;
    for (int threads : thread_counts(arguments)) {
      ASSIGN_OR_RETURN(const FrameTimes times,
                       times_of(system, BackendKind::kCpu, named.smoother, threads));
      if (threads == 1) one_thread = times;
      ablation.add({mesh, system.name, vertices, corners, std::string(named.name),
                    static_cast<double>(threads), times.solve, times.rhs, times.matrix,
                    times.evaluate, per_second(times.solve), per_second(times.rhs),
                    per_second(times.matrix), per_second(times.solve + times.evaluate),
                    per_second(times.rhs + times.evaluate),
                    per_second(times.matrix + times.evaluate)});
      if (named.smoother != SolverOptions().smoother || threads != arguments.threads) continue;
      add_to_table_1("cpu", times, one_thread.solve / times.solve);
      on_cpu = times;
    }
  }
  if (!cuda_device().is_ok()) return Status::ok();
  ASSIGN_OR_RETURN(const FrameTimes times,
                   times_of(system, BackendKind::kCuda, Smoother::kSchwarz, arguments.threads));
  add_to_table_1("cuda", times, on_cpu.solve / times.solve);
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& ablation = report.add_table("figure7", ablation_columns());
  BenchTable& table_1 = report.add_table("table1", {{"scan", "", 18},
                                                    {"backend", "", 8},
                                                    {"vertices", "%.0f"},
                                                    {"corners", "%.0f"},
                                                    {"solve_fps", "%.1f"},
                                                    {"rhs_fps", "%.1f"},
                                                    {"matrix_fps", "%.1f"},
                                                    {"speed_up", "%.2f"}});
  for (const ScanArgument& scan : arguments.scans) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    const int finest = depth_of(scan, mesh);
    for (int depth = std::max(kDepthMin, finest - kDepths + 1); depth <= finest; ++depth) {
      ASSIGN_OR_RETURN(const auto system, system_or_remark(scan, mesh, depth, arguments, report));
      if (system)
        RETURN_IF_ERROR(report_system(scan.name(), *system, arguments, ablation, table_1));
    }
  }
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"figure7_bench", {"tablet:1000000@9", "blob:250000@8"}, burnish::run},
                             argc, argv);
}

// Figure 7: frames per second in the three states of the system, at three depths. `figure7` has all
// smoothers by threads, and CUDA's if there is a device. `ablation` shows the gain of each step of
// the paper, and of further ones.

#include "server/solver/cuda/cuda_backend.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/frames.h"

namespace burnish {
namespace {

constexpr int kDepths = 3;  // the scan's and the coarser ones

double per_second(double milliseconds) {
  return 1000 / milliseconds;
}

/// A smoother on a backend, on all threads or on one. Either this program or the client evaluates
/// the vertices.
struct Bar {
  const char* name;
  BackendKind backend;
  Smoother smoother;
  bool on_all_threads = true;
  bool evaluates = false;
};

/// The paper's plainest smoother comes first, then its additions, then the product's own.
constexpr Bar kBars[] = {
    {"serial_evaluate", BackendKind::kCpu, Smoother::kSlices, false, true},
    {"serial", BackendKind::kCpu, Smoother::kSlices, false},
    {"threads", BackendKind::kCpu, Smoother::kSlices},
    {"blocked", BackendKind::kCpu, Smoother::kBlockedSlices},
    {"schwarz", BackendKind::kCpu, Smoother::kSchwarz},
    {"cuda_gauss_seidel", BackendKind::kCuda, Smoother::kGaussSeidel},
    {"cuda_schwarz", BackendKind::kCuda, Smoother::kSchwarz},
    {"cuda_schwarz_evaluate", BackendKind::kCuda, Smoother::kSchwarz, true, true},
};

struct State {
  const char* name;
  double FrameTimes::*time;
};
constexpr State kStates[] = {
    {"solve", &FrameTimes::solve}, {"rhs", &FrameTimes::rhs}, {"matrix", &FrameTimes::matrix}};

bool has_device() {
  return cuda_device().is_ok();
}

/// All measurements of one system.
class Frames {
 public:
  explicit Frames(const BenchSystem& system) : system_(system) {}

  Result<FrameTimes> measure(const SolverOptions& options) {
    ASSIGN_OR_RETURN(const auto session, Session::open(system_, options));
    measured_.emplace_back(options, measure_frames(*session, TransferCurve(kAlphaDefault)));
    RETURN_IF_ERROR(session->solver().status());
    return measured_.back().second;
  }

  /// Needs: it was measured.
  const FrameTimes& of(BackendKind backend, Smoother smoother, int threads) const {
    for (const auto& [options, times] : measured_)
      if (options.backend == backend && options.smoother == smoother && options.threads == threads)
        return times;
    BURNISH_CHECK(false, "every bar is measured");
  }

 private:
  const BenchSystem& system_;
  std::vector<std::pair<SolverOptions, FrameTimes>> measured_;
};

std::vector<BenchTable::Column> figure_7_columns() {
  return {{"mesh", "", 16},
          {"scan", "", 18},
          {"vertices", "%.0f"},
          {"corners", "%.0f"},
          {"backend"},
          {"smoother", "", 18},
          {"threads", "%.0f"},
          {"solve_ms", "%.2f"},
          {"rhs_ms", "%.2f"},
          {"matrix_ms", "%.2f"},
          {"evaluate_ms", "%.2f"},
          {"solve_fps", "%.1f"},
          {"rhs_fps", "%.1f"},
          {"matrix_fps", "%.1f"},
          {"solve_evaluate_fps", "%.1f"},
          {"rhs_evaluate_fps", "%.1f"},
          {"matrix_evaluate_fps", "%.1f"}};
}

std::vector<BenchTable::Column> ablation_columns() {
  std::vector<BenchTable::Column> columns = {
      {"scan", "", 18}, {"corners", "%.0f"}, {"state", "", 6}};
  for (const Bar& bar : kBars)
    if (bar.backend == BackendKind::kCpu || has_device())
      columns.push_back({std::string(bar.name) + "_fps", "%.1f"});
  return columns;
}

struct Tables {
  BenchTable &figure_7, &ablation;
};

Status measure_all(const std::string& mesh, const BenchSystem& system,
                   const BenchArguments& arguments, Frames& frames, BenchTable& table) {
  const auto measure = [&](BackendKind backend, Smoother smoother, int threads) -> Status {
    ASSIGN_OR_RETURN(const FrameTimes times, frames.measure({backend, smoother, threads}));
    table.add({mesh, system.name, static_cast<double>(system.prepared->vertices.size()),
               static_cast<double>(system.corners()), backend == BackendKind::kCpu ? "cpu" : "cuda",
               std::string(name_of(smoother)), static_cast<double>(threads), times.solve, times.rhs,
               times.matrix, times.evaluate, per_second(times.solve), per_second(times.rhs),
               per_second(times.matrix), per_second(times.solve + times.evaluate),
               per_second(times.rhs + times.evaluate), per_second(times.matrix + times.evaluate)});
    return Status::ok();
  };
  for (const NamedSmoother& named : kSmoothers)
    for (const int threads : thread_counts(arguments))
      RETURN_IF_ERROR(measure(BackendKind::kCpu, named.smoother, threads));
  if (has_device())
    for (const Smoother smoother : kCudaSmoothers)
      RETURN_IF_ERROR(measure(BackendKind::kCuda, smoother, arguments.threads));
  return Status::ok();
}

void add_to_ablation(const BenchSystem& system, const BenchArguments& arguments,
                     const Frames& frames, BenchTable& table) {
  for (const State& state : kStates) {
    std::vector<BenchTable::Value> row = {system.name, static_cast<double>(system.corners()),
                                          state.name};
    for (const Bar& bar : kBars) {
      if (bar.backend == BackendKind::kCuda && !has_device()) continue;
      const FrameTimes& times =
          frames.of(bar.backend, bar.smoother, bar.on_all_threads ? arguments.threads : 1);
      row.emplace_back(per_second(times.*state.time + (bar.evaluates ? times.evaluate : 0)));
    }
    table.add(row);
  }
}

Status report_system(const std::string& mesh, const BenchSystem& system,
                     const BenchArguments& arguments, const Tables& tables) {
  Frames frames(system);
  RETURN_IF_ERROR(measure_all(mesh, system, arguments, frames, tables.figure_7));
  add_to_ablation(system, arguments, frames, tables.ablation);
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  const Tables tables = {report.add_table("figure7", figure_7_columns()),
                         report.add_table("ablation", ablation_columns())};
  for (const ScanArgument& scan : arguments.scans) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    const int finest = depth_of(scan, mesh);
    for (int depth = std::max(kDepthMin, finest - kDepths + 1); depth <= finest; ++depth) {
      ASSIGN_OR_RETURN(const auto system, system_or_remark(scan, mesh, depth, arguments, report));
      if (system) RETURN_IF_ERROR(report_system(scan.name(), *system, arguments, tables));
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

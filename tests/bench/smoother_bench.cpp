// Measures every smoother's distance from the converged surface, by cycle and by millisecond;
// CUDA's too if there is a device.

#include "common/base/parallel.h"
#include "server/solver/cuda/cuda_backend.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/converged.h"
#include "tests/bench/frames.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr int kCycles = 20;

/// A session's edit from the unfiltered surface. Every smoother settles that surface exactly at β =
/// 1. The result of an edit of β depends only on the difference of β, so an edit from here is like
/// an edit from any settled state.
struct Case {
  const char* name;
  TransferCurve curve;
  double beta;
  bool stroke = false;
};

std::vector<Case> cases() {
  const TransferCurve contrast = TransferCurve::parse("-20:5,20:500").value();
  return {{"cold_alpha-5", TransferCurve(5), 0},
          {"cold_alpha-50", TransferCurve(50), 0},
          {"cold_contrast-100", contrast, 0},
          {"slider-step_alpha-50", TransferCurve(50), 0.9},
          {"stroke_alpha-50", TransferCurve(50), 1, true},
          {"stroke_contrast-100", contrast, 1, true}};
}

constexpr double kStrokeRadius = 0.1;  // of the diagonal
constexpr double kStrokeBeta = 2;

Fields fields_of(const Case& what, const PreparedMesh& prepared) {
  Fields fields(prepared);
  fields.set_transfer_curve(what.curve);
  fields.set_gradient_scale(what.beta);
  if (what.stroke)
    fields.paint({{.radius = kStrokeRadius * prepared.statistics.diagonal(), .beta = kStrokeBeta},
                  {prepared.vertices[prepared.vertices.size() / 3]}});
  return fields;
}

std::vector<SolverOptions> every_smoother(int threads) {
  std::vector<SolverOptions> all;
  for (const NamedSmoother& named : kSmoothers)
    all.push_back({BackendKind::kCpu, named.smoother, threads});
  if (cuda_device().is_ok())
    for (const Smoother smoother : kCudaSmoothers)
      all.push_back({BackendKind::kCuda, smoother, threads});
  return all;
}

// Makes two steps of either kind on the unfiltered surface, which do not move it: a device records
// them.
void warm_up(Solver& solver, Case what, const PreparedMesh& prepared) {
  what.beta = 1;
  what.stroke = false;
  const Fields fields = fields_of(what, prepared);
  for (int i = 0; i < 2; ++i) {
    solver.set_metric(fields.view());
    solver.step();
    solver.step();
  }
}

Status report_smoother(const BenchSystem& system, const Case& what, const SolverOptions& options,
                       const Converged& converged, BenchTable& table) {
  ASSIGN_OR_RETURN(const auto solver, Solver::create(system, options));
  warm_up(*solver, what, *system.prepared);
  const Fields fields = fields_of(what, *system.prepared);
  const double matrix = milliseconds([&] { solver->set_metric(fields.view()); });
  double time = 0;
  for (int cycle = 1; cycle <= kCycles; ++cycle) {
    time += milliseconds([&] { solver->step(); });
    const VertexDistance distance = converged.distance(*solver);
    table.add({system.name, what.name, std::string(solver->backend_name()),
               std::string(name_of(options.smoother)), static_cast<double>(cycle), time,
               distance.max, distance.rms, matrix});
  }
  return solver->status();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& references = report.add_table("converged", {{"scan", "", 18},
                                                          {"case", "", 22},
                                                          {"cycles", "%.0f"},
                                                          {"residual", "%.1e"},
                                                          {"correction", "%.1e"},
                                                          {"moved_max", "%.1e"}});
  BenchTable& errors = report.add_table("smoothers", {{"scan", "", 18},
                                                      {"case", "", 22},
                                                      {"backend", "", 8},
                                                      {"smoother", "", 18},
                                                      {"cycle", "%.0f"},
                                                      {"time_ms", "%.1f"},
                                                      {"max", "%.1e"},
                                                      {"rms", "%.1e"},
                                                      {"matrix_ms", "%.1f"}});
  for (const ScanArgument& scan : arguments.scans) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    ASSIGN_OR_RETURN(const auto system,
                     system_or_remark(scan, mesh, depth_of(scan, mesh), arguments, report));
    if (!system) continue;
    for (const Case& what : cases()) {
      const Fields fields = fields_of(what, *system->prepared);
      ASSIGN_OR_RETURN(const Converged converged, Converged::solve(*system, fields.view()));
      references.add({system->name, what.name, static_cast<double>(converged.cycles),
                      converged.residual, converged.correction, converged.moved_max});
      for (const SolverOptions& options : every_smoother(arguments.threads))
        RETURN_IF_ERROR(report_smoother(*system, what, options, converged, errors));
    }
  }
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"smoother_bench", {"blob:250000@8"}, burnish::run}, argc, argv);
}

// Measures preparation by phase, memory, and the frames of three transfer curves, for whole scans.

#include "common/base/process_memory.h"
#include "server/prepare/prepare.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/frames.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

struct Tables {
  BenchTable& preparation;
  BenchTable& memory;
  BenchTable& frames;
};

struct Curve {
  const char* name;
  TransferCurve curve;
};

std::vector<Curve> curves() {
  return {{"alpha-5", TransferCurve(5)},
          {"alpha-50", TransferCurve(50)},
          {"contrast-100", TransferCurve::parse("-20:5,20:500").value()}};
}

// Only this program times preparation itself.
BenchSystem prepare_timed(const std::string& name, const TriangleMesh& mesh, int depth,
                          BenchTable& table) {
  BenchSystem system;
  system.name = name;
  PrepareReport phases;
  const double total =
      milliseconds([&] { system.prepared = prepare(mesh, {.depth = depth}, {}, &phases).value(); });
  for (const auto& phase : phases.phases)
    table.add({name, phase.name, phase.seconds, static_cast<double>(phase.peak_bytes >> 20)});
  const double connect = milliseconds(
      [&] { static_cast<Multigrid&>(system) = make_multigrid(system.prepared).value(); });
  table.add({name, "prepare", total * 1e-3, static_cast<double>(peak_resident_bytes() >> 20)});
  table.add({name, "hierarchy", connect * 1e-3, static_cast<double>(peak_resident_bytes() >> 20)});
  return system;
}

void report_memory(const BenchSystem& system, const Session& session, BenchTable& table) {
  const double cells = static_cast<double>(system.prepared->cells.size());
  const double corners = system.corners();
  table.add({system.name, static_cast<double>(system.prepared->vertices.size()), corners, cells,
             static_cast<double>(system.prepared->integrals.size_bytes()) / cells,
             static_cast<double>(system.hierarchy->byte_count()) / corners,
             static_cast<double>(session.solver().byte_count()) / corners});
}

Status report_scan(const ScanArgument& scan, const BenchArguments& arguments, BenchReport& report,
                   Tables& tables) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  const int depth = depth_of(scan, mesh);
  const std::string name = scan.name() + "@" + std::to_string(depth);
  const Status fits = check_size(name, mesh, depth, arguments.corners_max);
  if (!fits.is_ok()) {
    report.remark("left out: " + fits.message());
    return Status::ok();
  }
  const BenchSystem system = prepare_timed(name, mesh, depth, tables.preparation);
  ASSIGN_OR_RETURN(const auto session, Session::open(system, {}));
  for (const auto& [curve_name, curve] : curves()) {
    const FrameTimes times = measure_frames(*session, curve);
    must_apply(*session, SetGradientScale{0});
    SolveReport settled;
    const double settle = milliseconds([&] { settled = session->solve({}).value(); });
    tables.frames.add({name, curve_name, times.solve, times.rhs, times.dab, times.matrix,
                       times.evaluate, static_cast<double>(settled.cycles), settle,
                       times.gigahertz});
  }
  report_memory(system, *session, tables.memory);
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  Tables tables{
      report.add_table(
          "preparation",
          {{"scan", "", 18}, {"phase", "", 12}, {"seconds", "%.3f"}, {"peak_mib", "%.0f"}}),
      report.add_table("memory", {{"scan", "", 18},
                                  {"vertices", "%.0f"},
                                  {"corners", "%.0f"},
                                  {"cells", "%.0f"},
                                  {"integrals_bytes_per_cell", "%.0f"},
                                  {"hierarchy_bytes_per_corner", "%.0f"},
                                  {"session_bytes_per_corner", "%.0f"}}),
      report.add_table("frames", {{"scan", "", 18},
                                  {"curve", "", 12},
                                  {"solve_ms", "%.1f"},
                                  {"rhs_ms", "%.1f"},
                                  {"dab_ms", "%.1f"},
                                  {"matrix_ms", "%.1f"},
                                  {"evaluate_ms", "%.1f"},
                                  {"settle_cycles", "%.0f"},
                                  {"settle_ms", "%.0f"},
                                  {"ghz", "%.1f"}})};
  for (const ScanArgument& scan : arguments.scans)
    RETURN_IF_ERROR(report_scan(scan, arguments, report, tables));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"scan_bench", {"blob:1000000@9", "tablet:1000000@9"}, burnish::run},
                             argc, argv);
}

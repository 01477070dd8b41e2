// The part of SessionManager that exports an edited mesh as a file.

#include "server/manager/session_manager_held.h"
#include "server/metrics/metrics.h"

namespace burnish {

// Others may submit edits between two cycles, because a solve may last for seconds. These do not
// touch the solved system: the fields follow the history only afterwards.
Result<SolveReport> SessionManager::solve(Held& held, const ExportWish& wish,
                                          const Progress& progress) {
  struct Solving {
    explicit Solving(bool& is_solving) : flag(is_solving) { flag = true; }
    ~Solving() { flag = false; }
    bool& flag;
  };
  SessionEntry& entry = *held.entry;
  RETURN_IF_ERROR(catch_up(entry, progress));
  const Solving solving(entry.solving);
  const Progress lending = [&](std::string_view phase, double fraction) {
    entry.mutex.let_place_pass();
    return report(progress, phase, fraction);
  };
  ASSIGN_OR_RETURN(const SolveReport solved,
                   entry.session->solve({wish.exact, wish.cycles}, lending));
  entry.last = solved.last;
  return solved;
}

Result<ExportSummary> SessionManager::solve_to_file(Held& held, const ExportWish& wish,
                                                    const std::filesystem::path& path,
                                                    const Progress& progress) {
  const auto solved = solve(held, wish, progress);
  tell_changed(*held.entry);
  RETURN_IF_ERROR(solved.status());
  const SolveReport& report_of_solve = solved.value();
  metrics().observe(Measure::kAssembleSeconds, report_of_solve.assemble_seconds);
  metrics().observe(Measure::kSolveSeconds, report_of_solve.solve_seconds);
  metrics().observe(Measure::kResidual, report_of_solve.last.residual);
  const TriangleMesh mesh = held.entry->session->surface();
  held.lock.unlock();

  if (!report(progress, "writing", 0)) return cancelled("the export was cancelled");
  RETURN_IF_ERROR(write_mesh(mesh, path));
  ExportSummary summary;
  summary.vertices = mesh.vertices.size();
  summary.triangles = mesh.triangles.size();
  summary.cycles = report_of_solve.cycles;
  summary.converged = report_of_solve.converged;
  summary.energy = report_of_solve.last.energy;
  summary.residual = report_of_solve.last.residual;
  summary.distance = report_of_solve.last.distance;
  summary.assemble_seconds = report_of_solve.assemble_seconds;
  summary.solve_seconds = report_of_solve.solve_seconds;
  return summary;
}

Result<std::unique_ptr<ExportFile>> SessionManager::export_mesh(const std::string& reference,
                                                                const ExportWish& wish,
                                                                const Caller& caller,
                                                                const Progress& progress) {
  ASSIGN_OR_RETURN(Held held, use(reference, caller, progress));
  const auto path = folder_.staging_path("." + std::string(mesh_format_name(wish.format)));
  ASSIGN_OR_RETURN(ExportSummary summary, solve_to_file(held, wish, path, progress));
  return ExportFile::adopt(path, std::move(summary));
}

}  // namespace burnish

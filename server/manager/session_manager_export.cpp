// The part of SessionManager that exports an edited mesh as a file.

#include <spdlog/spdlog.h>

#include "common/base/loop_progress.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/rewrite/left_out/left_out.h"
#include "common/mesh/rewrite/write_plan.h"
#include "server/manager/session_manager_held.h"
#include "server/metrics/metrics.h"

namespace burnish {

/// Decides before the solve which format is sent. Fails: invalid_argument if the scan is not
/// written in the format.
static Result<MeshFormat> format_to_send(MeshStore& store, const ScanInfo& scan,
                                         const ExportWish& wish, const Progress& progress) {
  if (scan.format != MeshFormat::kZip) {
    RETURN_IF_ERROR(find_way(scan.format, scan.format, wish.format, scan.name).status());
    return wish.format;
  }
  const auto original = store.find_original(scan.id, progress);
  const bool is_damaged = original.status().code() == StatusCode::kDataLoss;
  if (is_damaged && is_written_for_any_scan(wish.format)) return wish.format;
  RETURN_IF_ERROR(original.status());
  ASSIGN_OR_RETURN(const WritePlan plan, plan_to_write(*original, wish.format));
  if (wish.with_files && plan.way == WriteWay::kUnpack) return MeshFormat::kZip;
  RETURN_IF_ERROR(check_one_file(plan));
  return wish.format;
}

/// Promises a picture's memory while it is written, and hears a cancel between its rows.
static FileBudget budget_of_pictures(Quota& memory, LoopProgress& rows, Quota::Share& share) {
  return [&](uint64_t bytes) -> Status {
    if (!rows.goes_on(0)) return cancelled("the export was cancelled");
    if (bytes == 0) return Status::ok();
    share = {};
    ASSIGN_OR_RETURN(share, memory.take(kServer, bytes));
    return Status::ok();
  };
}

/// Writes the surface by the scan's original. Says in the summary what the file leaves out. Edits
/// must leave a server whose original is damaged: then writes what the prepared mesh knows.
static Status write_surface(MeshStore& store, const std::string& scan_id, const MovedMesh& moved,
                            MeshFormat format, const std::filesystem::path& path,
                            const Progress& progress, ExportSummary& summary) {
  const auto original = store.find_original(scan_id, progress);
  const FileBudget heard = heard_budget(progress, "writing");
  if (original.status().code() == StatusCode::kDataLoss && is_written_for_any_scan(format)) {
    spdlog::warn("an export without the original: {}", original.status().message());
    RETURN_IF_ERROR(write_mesh(moved.after, path, heard));
    summary.left_out = {
        "all but positions, triangles and colours, because the original is damaged"};
    return Status::ok();
  }
  RETURN_IF_ERROR(original.status());
  ASSIGN_OR_RETURN(summary.left_out, attributes_left_out(*original, format, moved.after, heard));
  LoopProgress rows(progress, "writing", 0, 0);
  Quota::Share share;
  PictureWork pictures{budget_of_pictures(store.memory(), rows, share), {}};
  RETURN_IF_ERROR(write_moved_mesh(*original, moved, path, &pictures, heard));
  summary.pictures = text_of(pictures.report);
  if (!moved.colours().is_there()) return Status::ok();
  ASSIGN_OR_RETURN(const auto names,
                   edited_colours_left_out(*original, format, moved.seams, pictures.report, heard));
  summary.left_out.insert(summary.left_out.end(), names.begin(), names.end());
  return Status::ok();
}

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
    entry.mutex.let_ticket_pass();
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
  const uint64_t edits = held.entry->edits;  // others may come during the solve
  const auto solved = solve(held, wish, progress);
  tell_changed(*held.entry);
  RETURN_IF_ERROR(solved.status());
  const SolveReport& report_of_solve = solved.value();
  metrics().observe(Measure::kAssembleSeconds, report_of_solve.assemble_seconds);
  metrics().observe(Measure::kSolveSeconds, report_of_solve.solve_seconds);
  metrics().observe(Measure::kResidual, report_of_solve.last.residual);
  const TriangleMesh mesh = held.entry->session->surface();
  const std::vector<TexelChange> texels = held.entry->session->texels();
  const SeamLevelling seams = held.entry->session->seams();
  const std::optional<double> volume = held.entry->session->kept_volume();
  const Controls controls = held.entry->session->edited().controls();
  const std::shared_ptr<const SharedMesh> shared = held.entry->mesh;
  held.lock.unlock();

  if (!report(progress, "writing", 0)) return cancelled("the export was cancelled");
  ExportSummary summary;
  const MovedMesh moved{shared->prepared->vertices, mesh,   controls.cap,
                        shared->prepared->colours,  texels, {seams.amount, seams.free}};
  RETURN_IF_ERROR(write_surface(store_, held.entry->record.scan_id, moved, wish.format, path,
                                progress, summary));
  if (wish.deviation)
    summary.deviation = deviation_of(shared->prepared->vertices, mesh.vertices, mesh.triangles);
  if (volume) {
    summary.volume = *volume;
    summary.lost_volume = lost_volume_text(*volume, controls);
  }
  summary.edits = edits;
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
  ASSIGN_OR_RETURN(const ScanInfo scan, store_.find(held.entry->record.scan_id));
  ExportWish sent = wish;
  ASSIGN_OR_RETURN(sent.format, format_to_send(store_, scan, wish, progress));
  const auto path = folder_.staging_path("." + std::string(mesh_format_name(sent.format)));
  const std::string file_name = "the server's file for the export";
  auto summary = solve_to_file(held, sent, path, progress);
  if (!summary.is_ok()) return summary.status().renamed(path.string(), file_name);
  summary->is_archive = sent.format != wish.format;
  auto file = ExportFile::adopt(path, std::move(*summary), progress);
  if (!file.is_ok()) return file.status().renamed(path.string(), file_name);
  return file;
}

}  // namespace burnish

#include "client/cli/filter/filter_file.h"

#include <chrono>
#include <iostream>

#include "client/cli/filter/fields_file.h"
#include "client/cli/filter/filter_output.h"
#include "client/cli/filter/filter_report.h"
#include "common/base/file_budget.h"
#include "common/base/loop_progress.h"
#include "common/base/out_of_memory.h"
#include "common/base/process_memory.h"
#include "common/denoise/edge_proposal.h"
#include "common/mesh/io/mesh_io.h"
#include "server/memory/opening_need.h"
#include "server/solver/device_probe.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {

namespace {

/// Bytes of the filter of normals, of its layer and of the wanted gradients.
uint64_t edge_bytes(const PreparationCounts& counts) {
  constexpr uint64_t kPerTriangle = 210, kPerVertex = 60, kPerCell = 72, kPerPiece = 16;
  return kPerTriangle * counts.triangles + kPerVertex * counts.vertices + kPerCell * counts.cells +
         kPerPiece * counts.pieces;
}

/// Allows as much memory as this machine has, first for the preparation, then for the mesh with its
/// session.
class FilterBudget final : public MachineBudget {
 public:
  explicit FilterBudget(const FilterOptions& options)
      : device_bytes_max_(device_bytes_max(options.solver.backend, options.solver.devices)),
        keeps_edges_(options.filter.keeps_edges()) {}

  Status ask(const PreparationNeed& need) override {
    RETURN_IF_ERROR(MachineBudget::ask(need));
    uint64_t bytes = predict_opened_bytes(need, device_bytes_max_);
    if (keeps_edges_) bytes += edge_bytes(need.counts);
    if (bytes <= memory_bytes_max()) return Status::ok();
    return resource_exhausted("solving takes " + std::to_string(bytes >> 20) +
                              " MiB; the machine has " + std::to_string(memory_bytes_max() >> 20) +
                              " MiB available");
  }

 private:
  const uint64_t device_bytes_max_;
  const bool keeps_edges_;
};

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

const char* how_to_free(const HeldRims& rims) {
  if (rims.held == 0) return "";
  return rims.held == 1 ? "; --pin-rims off lets it move" : "; --pin-rims off lets them move";
}

/// Asks the scan's own noise, if the user leaves it to that, and says the answer.
Status propose(const PreparedMesh& prepared, const Progress& progress, FilterChoice& choice,
               FilterRun& run) {
  if (!choice.asks_for_noise()) return Status::ok();
  MeshView mesh;
  mesh.vertices = prepared.vertices;
  mesh.triangles = prepared.triangles;
  if (choice.asks_for_proposal()) {
    ASSIGN_OR_RETURN(const auto surface, make_denoise_surface(mesh, {}, progress));
    ASSIGN_OR_RETURN(run.proposal, propose_edges(*surface, {}, progress));
  } else {
    ASSIGN_OR_RETURN(run.proposal, measure_noise(mesh, {}, progress));
  }
  std::cerr << choice.take(*run.proposal);
  return Status::ok();
}

Status apply_edits(const FilterOptions& options, const FilterChoice& choice,
                   const std::vector<Edit>& edits, Session& session) {
  const PreparedMesh& prepared = session.prepared();
  const bool keeps_volume = options.controls.over(kNewSessionControls).keep_volume;
  const ScanLengths lengths{prepared.length_unit,
                            prepared.frame.cell_size,
                            prepared.statistics.mean_edge_length,
                            sharp_bend_of(prepared.histogram.range, prepared.histogram.area),
                            choice.noise,
                            !keeps_volume && choice.equaliser.bands.empty()};
  std::cerr << told_preset(choice, lengths);
  ASSIGN_OR_RETURN(const auto filter, changes_of(choice, lengths, {}));
  LayerCheck layers = session.edited().layers();
  for (const auto& change : filter) {
    RETURN_IF_ERROR(session.edited().check_new({"filter", change}));
    RETURN_IF_ERROR(layers.take({"filter", change}));
    RETURN_IF_ERROR(session.apply({"filter", change}));
  }
  if (session.fields().transfer_curve().contrast() > kCurveContrastWarn)
    std::cerr << "warning: the curve's contrast is above " << kCurveContrastWarn
              << ": convergence is slower and accuracy is lower\n";
  for (const Edit& edit : edits) {
    RETURN_IF_ERROR(session.edited().check_new(edit));
    RETURN_IF_ERROR(layers.take(edit));
    RETURN_IF_ERROR(session.apply(edit));
  }
  const auto rims = session.edited().pinned_rims();
  if (rims && rims->rims > 0 && !options.controls.pin_rims)
    std::cerr << describe(*rims) << how_to_free(*rims) << "\n";
  if (const std::string walls = describe(prepared.walls); !walls.empty())
    std::cerr << walls << "\n";
  return Status::ok();
}

Result<Multigrid> make_hierarchy(const std::shared_ptr<const PreparedMesh>& prepared,
                                 const Progress& progress, FilterRun& run) {
  const Stopwatch connecting;
  Multigrid multigrid;
  RETURN_IF_ERROR(with_memory_for("the hierarchy", [&]() -> Status {
    ASSIGN_OR_RETURN(multigrid, make_multigrid(prepared, progress));
    return Status::ok();
  }));
  const Hierarchy& hierarchy = *multigrid.hierarchy;
  run.hierarchy_seconds = connecting.seconds();
  run.hierarchy_bytes = hierarchy.byte_count();
  run.corners = hierarchy.at(hierarchy.finest).grid.corner_count();
  return multigrid;
}

void warn_unless_converged(const FilterOptions& options, const SolveReport& solve) {
  if (solve.last.fell_back)
    std::cerr << "warning: a step of the solver was not sound; a plainer smoother went on\n";
  if (!solve.converged && options.solve.cycles == 0)
    std::cerr << "warning: not converged after " << solve.cycles << " cycles; estimated distance "
              << solve.last.distance << " of the diagonal\n";
}

void warn_unless_volume_is_kept(const Session& session) {
  const auto volume = session.kept_volume();
  if (!volume) return;
  const std::string lost = lost_volume_text(*volume, session.edited().controls());
  if (!lost.empty()) std::cerr << "warning: " << lost << "\n";
}

/// Hears a cancel between rows of pictures. A picture takes memory that is there now.
FileBudget budget_of_pictures(LoopProgress& rows) {
  return [&rows](uint64_t bytes) -> Status {
    if (!rows.goes_on(0)) return cancelled("writing pictures was cancelled");
    const uint64_t bytes_max = bytes == 0 ? UINT64_MAX : available_memory_bytes();
    if (bytes <= bytes_max) return Status::ok();
    return resource_exhausted("writing takes " + std::to_string(bytes >> 20) +
                              " MiB; the machine has " + std::to_string(bytes_max >> 20) +
                              " MiB available");
  };
}

/// Writes OUT, and says in the facts what it has of edited colours.
Status write_out(const FilterOptions& options, const FilterPaths& paths,
                 const FilterFormats& formats, const MovedMesh& moved, const Progress& progress,
                 FilteredFacts& facts) {
  LoopProgress rows(progress, "pictures", 0, 0);
  PictureWork pictures{budget_of_pictures(rows), {}};
  RETURN_IF_ERROR(write_surface(options, paths, formats, moved, pictures));
  facts.pictures = std::move(pictures.report);
  if (!moved.colours().is_there()) return Status::ok();
  ASSIGN_OR_RETURN(const auto names,
                   tell_colours_left_out(paths, formats, moved.seams, facts.pictures));
  facts.left_out.insert(facts.left_out.end(), names.begin(), names.end());
  return Status::ok();
}

void add_facts_of(const TriangleMesh& mesh, const Session& session, const FilterRun& run,
                  FilteredFacts& facts) {
  facts.vertices = mesh.vertices.size();
  facts.triangles = mesh.triangles.size();
  facts.depth = session.prepared().frame.depth;
  facts.corners = run.corners;
  facts.cycles = run.solve.cycles;
  facts.converged = run.solve.converged;
  facts.distance = run.solve.last.distance;
  facts.volume = run.volume;
}

}  // namespace

Result<FilteredFacts> filter_file(const FilterOptions& options, const std::vector<Edit>& edits,
                                  const FilterPaths& paths) {
  const Stopwatch whole;
  ASSIGN_OR_RETURN(const FilterFormats formats, check_filter_paths(options, paths));
  FilterRun run;
  ProgressPrinter printer(options.progress);
  FilterBudget budget(options);
  PrepareOptions prepare_options = options.prepare;
  prepare_options.budget = &budget;
  const Stopwatch reading;
  ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(paths.in));
  run.read_seconds = reading.seconds();
  FilteredFacts facts;
  ASSIGN_OR_RETURN(facts.left_out, tell_left_out(paths, formats, mesh));
  const auto preparing = prepare(mesh, prepare_options, printer.progress(), &run.prepare);
  if (!preparing.is_ok()) return preparing.status().with_context(paths.in.string());
  const auto& prepared = *preparing;
  ASSIGN_OR_RETURN(const Multigrid multigrid, make_hierarchy(prepared, printer.progress(), run));
  ASSIGN_OR_RETURN(const auto session, Session::open(multigrid, options.solver));
  FilterChoice choice = options.filter;
  RETURN_IF_ERROR(propose(*prepared, printer.progress(), choice, run));
  RETURN_IF_ERROR(apply_edits(options, choice, edits, *session));
  if (session->fields().texture().level_seams > 0)
    RETURN_IF_ERROR(check_has_pictures(paths, formats.in));
  if (!options.fields_file.empty())
    RETURN_IF_ERROR(write_fields_file(*session, options.fields_file));
  ASSIGN_OR_RETURN(run.solve, session->solve(options.solve, printer.progress()));
  const Stopwatch writing;
  ASSIGN_OR_RETURN(const TriangleMesh surface,
                   with_memory_for("the filtered surface",
                                   [&]() -> Result<TriangleMesh> { return session->surface(); }));
  const std::vector<TexelChange> texels = session->texels();
  const SeamLevelling seams = session->seams();
  RETURN_IF_ERROR(write_out(options, paths, formats,
                            {mesh.vertices,
                             surface,
                             session->edited().controls().cap,
                             mesh.colours,
                             texels,
                             {seams.amount, seams.free}},
                            printer.progress(), facts));
  run.write_seconds = writing.seconds();
  run.volume = session->kept_volume();
  if (!paths.report.empty()) RETURN_IF_ERROR(write_filter_report(*session, run, paths.report));
  warn_unless_converged(options, run.solve);
  warn_unless_volume_is_kept(*session);
  add_facts_of(mesh, *session, run, facts);
  facts.seconds = whole.seconds();
  return facts;
}

}  // namespace burnish

#include "client/cli/filter/filter_file.h"

#include <chrono>
#include <iostream>

#include "client/cli/filter/fields_file.h"
#include "client/cli/filter/filter_report.h"
#include "client/cli/filter/pack_output.h"
#include "client/cli/warn_of_left_out.h"
#include "common/base/atomic_file.h"
#include "common/base/out_of_memory.h"
#include "common/bundle/place_mesh.h"
#include "common/bundle/scan_bundle.h"
#include "common/mesh/mesh_io.h"
#include "common/mesh/rewrite/left_out.h"
#include "common/mesh/rewrite/rewrite.h"
#include "server/memory/opening_need.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {

namespace {

/// Allows as much memory as this machine has, first for the preparation, then for the mesh with its
/// session.
class FilterBudget final : public MachineBudget {
 public:
  Status ask(const PreparationNeed& need) override {
    RETURN_IF_ERROR(MachineBudget::ask(need));
    const uint64_t bytes = predict_opened_bytes(need);
    if (bytes <= memory_bytes_max()) return Status::ok();
    return resource_exhausted("solving takes " + std::to_string(bytes >> 20) +
                              " MiB; the machine has " + std::to_string(memory_bytes_max() >> 20) +
                              " MiB available");
  }
};

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A .gltf whose positions lie in another file is written again in an archive only.
Status check_buffers(const FilterPaths& paths, MeshFormat in, MeshFormat out) {
  if (in != MeshFormat::kGltf || out != MeshFormat::kGltf) return Status::ok();
  ASSIGN_OR_RETURN(const ScanBundle bundle, ScanBundle::open(paths.in));
  if (bundle.beside().empty()) return Status::ok();
  return invalid_argument(paths.in.string() + " names " + bundle.beside()[0] +
                          " beside it; write a .zip archive, or another format");
}

/// The formats of a run.
struct Formats {
  MeshFormat in, out;
  bool packs() const { return out == MeshFormat::kZip && in != MeshFormat::kZip; }
};

/// Refuses wrong options before the long work begins.
Result<Formats> check_files(const FilterOptions& options, const FilterPaths& paths) {
  Formats formats{};
  ASSIGN_OR_RETURN(formats.in, mesh_format_of_path(paths.in));
  ASSIGN_OR_RETURN(formats.out, written_format_of_path(paths.out));
  if (formats.out != formats.in && !formats.packs() && !is_written_for_any_scan(formats.out))
    return invalid_argument(paths.out_name + ": only a file of the same format is written as " +
                            paths.out.extension().string() +
                            "; use .ply, .obj, .stl, .glb or .zip");
  RETURN_IF_ERROR(check_buffers(paths, formats.in, formats.out));
  std::error_code ignored;
  if (!options.force && std::filesystem::equivalent(paths.in, paths.out, ignored))
    return invalid_argument(paths.out_name + " is the file to read; --force replaces it");
  RETURN_IF_ERROR(check_writable(paths.out));
  return formats;
}

Status apply_edits(const FilterOptions& options, const std::vector<Edit>& edits, Session& session) {
  const PreparedMesh& prepared = session.prepared();
  ASSIGN_OR_RETURN(const auto filter,
                   changes_of(options.filter, prepared.length_unit, prepared.frame.cell_size));
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
  if (session.fields().hold() && !options.controls.pin_rims)
    std::cerr << "the rims stay where they are; --pin-rims off lets them move\n";
  return Status::ok();
}

/// Writes the solved surface in the format of `paths.out`, with the files beside it.
Status write_surface(const FilterOptions& options, const FilterPaths& paths, Formats formats,
                     const MovedMesh& moved) {
  if (formats.packs()) return write_packed_mesh(paths.in, moved, paths.out);
  RETURN_IF_ERROR(write_moved_mesh({paths.in, formats.in, paths.in.string()}, moved, paths.out));
  return place_files_of(paths.in, paths.out, options.force);
}

Result<std::vector<std::string>> tell_left_out(const FilterPaths& paths, Formats formats,
                                               const TriangleMesh& mesh) {
  if (formats.packs()) return std::vector<std::string>();
  const OriginalFile original = {paths.in, formats.in, paths.in.string()};
  ASSIGN_OR_RETURN(auto left_out, attributes_left_out(original, formats.out, mesh));
  warn_of_left_out(left_out, paths.out_name);
  return left_out;
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
  if (!solve.converged && options.solve.cycles == 0)
    std::cerr << "warning: not converged after " << solve.cycles << " cycles; estimated distance "
              << solve.last.distance << " of the diagonal\n";
}

FilteredFacts facts_of(const TriangleMesh& mesh, const Session& session, const FilterRun& run) {
  FilteredFacts facts;
  facts.vertices = mesh.vertices.size();
  facts.triangles = mesh.triangles.size();
  facts.depth = session.prepared().frame.depth;
  facts.corners = run.corners;
  facts.cycles = run.solve.cycles;
  facts.converged = run.solve.converged;
  facts.distance = run.solve.last.distance;
  return facts;
}

}  // namespace

Result<FilteredFacts> filter_file(const FilterOptions& options, const std::vector<Edit>& edits,
                                  const FilterPaths& paths) {
  const Stopwatch whole;
  ASSIGN_OR_RETURN(const Formats formats, check_files(options, paths));
  FilterRun run;
  ProgressPrinter printer(options.progress);
  FilterBudget budget;
  PrepareOptions prepare_options = options.prepare;
  prepare_options.budget = &budget;
  const Stopwatch reading;
  ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(paths.in));
  run.read_seconds = reading.seconds();
  ASSIGN_OR_RETURN(auto left_out, tell_left_out(paths, formats, mesh));
  ASSIGN_OR_RETURN(const auto prepared,
                   prepare(mesh, prepare_options, printer.progress(), &run.prepare));
  ASSIGN_OR_RETURN(const Multigrid multigrid, make_hierarchy(prepared, printer.progress(), run));
  ASSIGN_OR_RETURN(const auto session, Session::open(multigrid, options.solver));
  RETURN_IF_ERROR(apply_edits(options, edits, *session));
  if (!options.fields_file.empty())
    RETURN_IF_ERROR(write_fields_file(*session, options.fields_file));
  ASSIGN_OR_RETURN(run.solve, session->solve(options.solve, printer.progress()));
  const Stopwatch writing;
  RETURN_IF_ERROR(write_surface(options, paths, formats, {mesh.vertices, session->surface()}));
  run.write_seconds = writing.seconds();
  if (!paths.report.empty()) RETURN_IF_ERROR(write_filter_report(*session, run, paths.report));
  warn_unless_converged(options, run.solve);
  FilteredFacts facts = facts_of(mesh, *session, run);
  facts.left_out = std::move(left_out);
  facts.seconds = whole.seconds();
  return facts;
}

}  // namespace burnish

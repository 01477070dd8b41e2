#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "client/cli/cell_field_file.h"
#include "client/cli/commands.h"
#include "client/cli/controls_options.h"
#include "client/cli/depth_table.h"
#include "client/cli/filter/fields_file.h"
#include "client/cli/filter/filter_report.h"
#include "client/cli/filter_choice.h"
#include "client/cli/progress_printer.h"
#include "client/cli/stroke_file.h"
#include "client/cli/warn_of_left_out.h"
#include "client/tools/own_presets.h"
#include "common/base/atomic_file.h"
#include "common/base/out_of_memory.h"
#include "common/base/parallel.h"
#include "common/bundle/place_mesh.h"
#include "common/bundle/scan_bundle.h"
#include "common/grid/depth_plan.h"
#include "common/mesh/mesh_io.h"
#include "common/mesh/rewrite/left_out.h"
#include "common/mesh/rewrite/rewrite.h"
#include "server/memory/opening_need.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {

namespace {

constexpr int kCyclesMax = 100'000;
constexpr int kThreadsMax = 1024;

struct FilterOptions {
  std::string in, out;
  bool force = false;
  bool depths = false;
  PrepareOptions prepare;
  SolverOptions solver;
  SolveOptions solve;
  FilterChoice filter;
  ControlsOptions controls;
  std::string paint_file, cell_field_file, fields_file, report_file;
};

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
Status check_buffers(const FilterOptions& options, MeshFormat in, MeshFormat out) {
  if (in != MeshFormat::kGltf || out != MeshFormat::kGltf) return Status::ok();
  ASSIGN_OR_RETURN(const ScanBundle bundle, ScanBundle::open(options.in));
  if (bundle.beside().empty()) return Status::ok();
  return invalid_argument(options.in + " names " + bundle.beside()[0] +
                          " beside it; pack both as a .zip archive, or write another format");
}

/// Refuses wrong options before the long work begins.
Result<OriginalFile> check_files(const FilterOptions& options) {
  ASSIGN_OR_RETURN(const MeshFormat in, mesh_format_of_path(options.in));
  ASSIGN_OR_RETURN(const MeshFormat out, written_format_of_path(options.out));
  if (out != in && !is_written_for_any_scan(out))
    return invalid_argument(options.out + ": only a file of the same format is written as " +
                            std::filesystem::path(options.out).extension().string() +
                            "; use .ply, .obj, .stl or .glb");
  RETURN_IF_ERROR(check_buffers(options, in, out));
  std::error_code ignored;
  if (!options.force && std::filesystem::equivalent(options.in, options.out, ignored))
    return invalid_argument(options.out + " is the file to read; --force replaces it");
  RETURN_IF_ERROR(check_writable(options.out));
  if (!options.filter.preset.empty())
    RETURN_IF_ERROR(find_any_preset(options.filter.preset).status());
  return OriginalFile{options.in, in, options.in};
}

Status warn_of_output(const FilterOptions& options, const OriginalFile& original,
                      const TriangleMesh& mesh) {
  ASSIGN_OR_RETURN(const MeshFormat out, mesh_format_of_path(options.out));
  ASSIGN_OR_RETURN(const auto left_out, attributes_left_out(original, out, mesh));
  warn_of_left_out(left_out, options.out);
  return Status::ok();
}

Result<std::vector<Edit>> read_edits(const FilterOptions& options) {
  std::vector<Edit> edits;
  if (!options.paint_file.empty()) {
    ASSIGN_OR_RETURN(std::vector<Stroke> strokes, read_stroke_file(options.paint_file));
    for (Stroke& stroke : strokes) edits.push_back({"paint", std::move(stroke)});
  }
  if (!options.cell_field_file.empty()) {
    ASSIGN_OR_RETURN(SetCellFields cells, read_cell_field_file(options.cell_field_file));
    edits.push_back({options.cell_field_file, std::move(cells)});
  }
  edits.push_back({"controls", SetControls{options.controls.over(kNewSessionControls)}});
  return edits;
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

void print_summary(const FilterOptions& options, const Session& session, const FilterRun& run) {
  if (!run.solve.converged && options.solve.cycles == 0)
    std::cerr << "warning: not converged after " << run.solve.cycles
              << " cycles; estimated distance " << run.solve.last.distance << " of the diagonal\n";
  std::cout << options.out << ": depth " << session.prepared().frame.depth << ", " << run.corners
            << " corners, " << run.solve.cycles << " cycles, estimated distance "
            << run.solve.last.distance << " of the diagonal\n";
}

Status filter(const FilterOptions& options) {
  ASSIGN_OR_RETURN(const OriginalFile original, check_files(options));
  use_threads(options.solver.threads);
  ASSIGN_OR_RETURN(const std::vector<Edit> edits, read_edits(options));
  FilterRun run;
  ProgressPrinter printer;

  FilterBudget budget;
  PrepareOptions prepare_options = options.prepare;
  prepare_options.budget = &budget;
  const Stopwatch reading;
  ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(options.in));
  run.read_seconds = reading.seconds();
  if (options.depths) {
    const MeshStatistics statistics = compute_statistics(mesh);
    print_depths(statistics, default_depth(statistics, budget.default_depth_bytes_max()));
    return Status::ok();
  }
  RETURN_IF_ERROR(warn_of_output(options, original, mesh));
  ASSIGN_OR_RETURN(const auto prepared,
                   prepare(mesh, prepare_options, printer.progress(), &run.prepare));
  const Stopwatch connecting;
  Multigrid multigrid;
  RETURN_IF_ERROR(with_memory_for("the hierarchy", [&]() -> Status {
    ASSIGN_OR_RETURN(multigrid, make_multigrid(prepared, printer.progress()));
    return Status::ok();
  }));
  const Hierarchy& hierarchy = *multigrid.hierarchy;
  run.hierarchy_seconds = connecting.seconds();
  run.hierarchy_bytes = hierarchy.byte_count();
  run.corners = hierarchy.at(hierarchy.finest).grid.corner_count();

  ASSIGN_OR_RETURN(const auto session, Session::open(multigrid, options.solver));
  RETURN_IF_ERROR(apply_edits(options, edits, *session));
  if (!options.fields_file.empty())
    RETURN_IF_ERROR(write_fields_file(*session, options.fields_file));
  ASSIGN_OR_RETURN(run.solve, session->solve(options.solve, printer.progress()));
  const Stopwatch writing;
  RETURN_IF_ERROR(write_moved_mesh(original, {mesh.vertices, session->surface()}, options.out));
  RETURN_IF_ERROR(place_files_of(options.in, options.out, options.force));
  run.write_seconds = writing.seconds();
  if (!options.report_file.empty())
    RETURN_IF_ERROR(write_filter_report(*session, run, options.report_file));
  print_summary(options, *session, run);
  return Status::ok();
}

void add_field_options(CLI::App& command, FilterOptions& options) {
  add_filter_options(command, options.filter);
  command.add_option("--beta-paint", options.paint_file,
                     "File of strokes: 'brush RADIUS STRENGTH BETA FALLOFF', then 'X Y Z' lines");
  command.add_option("--cell-field", options.cell_field_file,
                     "File of cells: 'i j k alpha1 alpha2 beta' lines, which override the fields");
  command.add_option("--fields-out", options.fields_file,
                     "Write 'i j k alpha1 alpha2 beta kappa1 kappa2' for every active cell");
}

void add_solve_options(CLI::App& command, FilterOptions& options) {
  CLI::Option* exact =
      command.add_flag("--exact", options.solve.exact, "Solve to the accuracy of final results");
  command.add_option("--cycles", options.solve.cycles, "Solve with exactly this many V-cycles")
      ->check(CLI::Range(1, kCyclesMax))
      ->excludes(exact);
  const std::map<std::string, BackendKind> backends = {
      {"auto", BackendKind::kAuto}, {"cpu", BackendKind::kCpu}, {"cuda", BackendKind::kCuda}};
  command.add_option("--backend", options.solver.backend, "cpu, cuda or auto")
      ->transform(CLI::CheckedTransformer(backends))
      ->type_name("NAME");
  std::map<std::string, Smoother> smoothers;
  std::string meanings;
  for (const NamedSmoother& named : kSmoothers) {
    smoothers.emplace(named.name, named.smoother);
    meanings.append("\n").append(named.name).append(": ").append(named.what);
  }
  command.add_option("--smoother", options.solver.smoother, "Smoother at each depth" + meanings)
      ->transform(CLI::CheckedTransformer(smoothers))
      ->type_name("NAME");
  command.add_option("--threads", options.solver.threads, "Processor cores to use (default: all)")
      ->check(CLI::Range(1, kThreadsMax));
  command.add_option("--report", options.report_file, "Write a report of the run: FILE.json");
}

}  // namespace

void add_filter_command(CommandTable& table) {
  const auto options = std::make_shared<FilterOptions>();
  CLI::App* command = table.add("filter", "Edit a scan in this process, without a server",
                                [options] { return filter(*options); });
  command->add_option("IN", options->in, "Mesh file: .ply, .obj, .stl, .off, .glb, .gltf or .zip")
      ->required();
  command->add_option("OUT", options->out, "File to write; the format of IN keeps all that IN has")
      ->required();
  command->add_flag("--force", options->force,
                    "Replace IN where OUT is the same file, and files beside OUT");
  command->add_option("--depth", options->prepare.depth, "Octree depth (default: by the mesh)")
      ->check(CLI::Range(kDepthMin, kDepthMax));
  command->add_flag("--depths", options->depths,
                    "Only tell what each depth would cost: cell size, memory, time to prepare");
  command
      ->add_option("--curvature-radius", options->prepare.curvature_radius,
                   "Average the curvature over this fraction of L")
      ->check(CLI::Range(0.0, 0.2));
  add_field_options(*command, *options);
  add_controls_options(*command, options->controls);
  add_solve_options(*command, *options);
}

}  // namespace burnish

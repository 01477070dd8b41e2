#include "client/cli/filter/filter_options.h"

#include <map>

#include "client/cli/in_range.h"
#include "common/base/limits.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

namespace {

constexpr int kCyclesMax = 100'000;
constexpr int kThreadsMax = 1024;

void add_field_options(CLI::App& command, FilterOptions& options) {
  add_filter_options(command, options.filter);
  add_edge_options(command, options.filter);
  command.add_option("--beta-paint", options.paint_file,
                     "File of strokes: 'brush RADIUS STRENGTH BETA FALLOFF [through]', then "
                     "'X Y Z' lines; 'through' paints through thin walls");
  command.add_option("--cell-field", options.cell_field_file,
                     "File of cells: 'i j k alpha1 alpha2 beta' lines, which override the fields");
  command.add_option("--fields-out", options.fields_file,
                     "Write 'i j k alpha1 alpha2 beta kappa1 kappa2' for every active cell");
}

void add_solve_options(CLI::App& command, FilterOptions& options) {
  CLI::Option* exact =
      command.add_flag("--exact", options.solve.exact, "Solve to the accuracy of final results");
  command.add_option("--cycles", options.solve.cycles, "Solve with exactly this many V-cycles")
      ->check(in_range(1, kCyclesMax))
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
      ->check(in_range(1, kThreadsMax));
}

void add_file_options(CLI::App& command, FilterOptions& options) {
  command
      .add_option("FILES", options.files,
                  "IN and OUT: " + extensions_text() +
                      "; '-' is standard input or output. With --out-dir each is an IN. The format "
                      "of IN keeps all that IN has")
      ->required();
  command.add_option("--out-dir", options.out_dir,
                     "Write each file under its own name into this folder, and make it");
  command.add_option("--from", options.from, "Format of standard input")
      ->check(CLI::IsMember(mesh_format_names()))
      ->capture_default_str();
  command
      .add_option("--to", options.to, "Format in the folder, or of standard output (default: IN's)")
      ->check(CLI::IsMember(mesh_format_names()));
  CLI::Option* force = command.add_flag(
      "--force", options.force, "Replace IN where OUT is the same file, and files beside OUT");
  CLI::Option* no_clobber =
      command.add_flag("--no-clobber", options.no_clobber, "Skip each OUT that is there")
          ->excludes(force);
  command.add_flag("--update", options.update, "Skip each OUT that is newer than its IN")
      ->excludes(no_clobber);
  CLI::Option* report =
      command.add_option("--report", options.report_file, "Write a report of the run: FILE.json");
  command.add_flag("--reports", options.reports, "Write a report beside each OUT: OUT.json")
      ->excludes(report);
  command.add_flag("--json", options.json, "Print the result as JSON");
  const std::map<std::string, ProgressStyle> styles = {{"text", ProgressStyle::kText},
                                                       {"json", ProgressStyle::kJson}};
  command.add_option("--progress", options.progress, "How progress is told on standard error")
      ->transform(CLI::CheckedTransformer(styles))
      ->type_name("text|json");
}

}  // namespace

void add_run_options(CLI::App& command, FilterOptions& options) {
  add_file_options(command, options);
  command.add_flag("--depths", options.depths,
                   "Only tell what each depth would cost: cell size, memory, time to prepare");
  add_work_options(command, options);
}

void add_work_options(CLI::App& command, FilterOptions& options) {
  command.add_option("--depth", options.prepare.depth, "Octree depth (default: by the mesh)")
      ->check(in_range(kDepthMin, kDepthMax));
  command
      .add_option("--curvature-radius", options.prepare.curvature_radius,
                  "Average the curvature over this fraction of L")
      ->check(in_range(0.0, 0.2));
  add_field_options(command, options);
  add_controls_options(command, options.controls);
  add_solve_options(command, options);
}

}  // namespace burnish

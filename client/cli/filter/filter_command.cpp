#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "client/cli/cell_field_file.h"
#include "client/cli/commands.h"
#include "client/cli/depth_table.h"
#include "client/cli/filter/filter_file.h"
#include "client/cli/filter/filter_jobs.h"
#include "client/cli/filter/filter_outcomes.h"
#include "client/cli/print_json.h"
#include "client/cli/stroke_file.h"
#include "client/tools/own_presets.h"
#include "common/base/parallel.h"
#include "common/grid/depth_plan.h"
#include "common/mesh/mesh_io.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

namespace {

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

/// Makes the folder for the files, if there is one.
Status make_out_dir(const FilterOptions& options) {
  std::error_code error;
  if (!options.out_dir.empty()) std::filesystem::create_directories(options.out_dir, error);
  if (error) return errno_status("cannot make the folder " + options.out_dir, error.value());
  return Status::ok();
}

/// Refuses, before the work, what cannot stand beside kept edges.
Status check_edges(const FilterOptions& options) {
  if (!options.filter.keeps_edges()) return Status::ok();
  const auto beside = [](const std::string& option, const char* why) {
    return unimplemented("--keep-edges cannot stand beside " + option + ": " + why);
  };
  constexpr const char* kNoisy = "bands have the scan's noise";
  if (options.controls.over(kNewSessionControls).keep_volume)
    return beside("--keep-volume on", "the layer that keeps edges is not in the volume");
  if (!options.filter.equaliser.bands.empty()) return beside("--band", kNoisy);
  if (options.filter.preset.empty()) return Status::ok();
  ASSIGN_OR_RETURN(const Preset preset, find_any_preset(options.filter.preset));
  if (!preset.bands.empty()) return beside("--preset '" + preset.name + "'", kNoisy);
  return Status::ok();
}

/// Fails: as the filter's own files cannot be read; not_found for an unknown preset; unimplemented
/// for what cannot stand beside kept edges.
Result<std::vector<Edit>> check_filter(const FilterOptions& options) {
  RETURN_IF_ERROR(check_edges(options));
  if (!options.filter.preset.empty())
    RETURN_IF_ERROR(find_any_preset(options.filter.preset).status());
  return read_edits(options);
}

Result<FilteredFacts> run_job(const FilterOptions& options, const std::vector<Edit>& edits,
                              const FilterJob& job) {
  ASSIGN_OR_RETURN(const JobFiles files, JobFiles::open(job, options));
  FilterPaths paths{files.in(), files.out(), options.report_file, job.out};
  if (options.reports) paths.report = job.out + ".json";
  auto facts = filter_file(options, edits, paths);
  if (!facts.is_ok()) return files.named(job, facts.status());
  RETURN_IF_ERROR(files.named(job, files.finish(job)));
  return facts;
}

FilterOutcome end_of_job(const FilterOptions& options, const std::vector<Edit>& edits,
                         const FilterJob& job) {
  FilterOutcome outcome{job, FilterEnd::kDone, {}, {}};
  if (options.no_clobber && std::filesystem::exists(job.out)) {
    outcome.end = FilterEnd::kSkipped;
    return outcome;
  }
  auto facts = run_job(options, edits, job);
  if (facts.is_ok()) {
    outcome.facts = std::move(*facts);
  } else {
    outcome.end = FilterEnd::kFailed;
    outcome.status = facts.status();
  }
  return outcome;
}

/// Tells of a job among several as it ends. The message of the only job is the program's own.
void tell(const FilterOptions& options, const FilterOutcome& outcome, size_t jobs) {
  if (outcome.end != FilterEnd::kFailed) {
    if (!options.json) print_outcome(outcome);
  } else if (jobs > 1) {
    std::cerr << "burnish: " << outcome.job.in << " failed: " << outcome.status.message() << "\n";
  }
}

Status print_depths_of(const FilterOptions& options) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(options.files[0]));
  const MeshStatistics statistics = compute_statistics(mesh);
  const int chosen = default_depth(statistics, MachineBudget().default_depth_bytes_max());
  if (options.json) {
    print_json(depths_to_json(statistics, chosen));
  } else {
    print_depths(statistics, chosen);
  }
  return Status::ok();
}

/// Fails: before the first job. Failed jobs are outcomes.
Status run_jobs(const FilterOptions& options, std::vector<FilterOutcome>& outcomes) {
  ASSIGN_OR_RETURN(const std::vector<FilterJob> jobs, plan_jobs(options));
  ASSIGN_OR_RETURN(const std::vector<Edit> edits, check_filter(options));
  RETURN_IF_ERROR(make_out_dir(options));
  use_threads(options.solver.threads);
  for (const FilterJob& job : jobs) {
    outcomes.push_back(end_of_job(options, edits, job));
    tell(options, outcomes.back(), jobs.size());
  }
  return Status::ok();
}

Status filter(const FilterOptions& options) {
  if (options.depths) return print_depths_of(options);
  std::vector<FilterOutcome> outcomes;
  const Status begun = run_jobs(options, outcomes);
  if (options.json) print_outcomes_json(outcomes, begun);
  RETURN_IF_ERROR(begun);
  return status_of(outcomes);
}

/// CLI11 reads numbers of files; this is the rest of what makes a usage error.
void check_usage(const FilterOptions& options) {
  const auto fail_with = [](const std::string& text) { throw CLI::ValidationError("FILES", text); };
  const auto jobs = plan_jobs(options);
  if (!jobs.is_ok() && !options.depths) fail_with(jobs.status().message());
  if (!options.out_dir.empty() && !options.report_file.empty())
    fail_with("--report is one file; --reports writes one beside each OUT");
  const bool prints_mesh =
      options.out_dir.empty() && !options.files.empty() && options.files.back() == kStandardStream;
  if (prints_mesh && (options.json || options.reports))
    fail_with("OUT '-' takes standard output: leave out --json and --reports");
}

}  // namespace

void add_filter_command(CommandTable& table) {
  const auto options = std::make_shared<FilterOptions>();
  CLI::App* command = table.add("filter", "Edit scans in this process, without a server",
                                [options] { return filter(*options); });
  command->parse_complete_callback([options] { check_usage(*options); });
  add_run_options(*command, *options);
}

}  // namespace burnish

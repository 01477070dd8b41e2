#include <iostream>
#include <memory>
#include <string>

#include "client/cli/commands.h"
#include "client/cli/depth_table.h"
#include "client/cli/filter/filter_jobs.h"
#include "client/cli/filter/filter_outcomes.h"
#include "client/cli/filter/filter_run.h"
#include "client/cli/print_json.h"
#include "common/base/parallel.h"
#include "common/grid/depth_plan.h"
#include "common/mesh/io/mesh_io.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

namespace {

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
    outcomes.push_back(run_job(options, edits, job));
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

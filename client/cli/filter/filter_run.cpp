#include "client/cli/filter/filter_run.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include "client/cli/cell_field_file.h"
#include "client/cli/filter/filter_file.h"
#include "client/cli/stroke_file.h"
#include "client/tools/own_presets.h"

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

Result<FilteredFacts> filtered(const FilterOptions& options, const std::vector<Edit>& edits,
                               const FilterJob& job) {
  ASSIGN_OR_RETURN(const JobFiles files, JobFiles::open(job, options));
  FilterPaths paths{files.in(), files.out(), options.report_file, job.out};
  if (options.reports) paths.report = job.out + ".json";
  auto facts = filter_file(options, edits, paths);
  if (!facts.is_ok()) return files.named(job, facts.status());
  RETURN_IF_ERROR(files.named(job, files.finish(job)));
  return facts;
}

}  // namespace

Status make_out_dir(const FilterOptions& options) {
  std::error_code error;
  if (!options.out_dir.empty()) std::filesystem::create_directories(options.out_dir, error);
  if (error) return errno_status("cannot make the folder " + options.out_dir, error.value());
  return Status::ok();
}

Result<std::vector<Edit>> check_filter(const FilterOptions& options) {
  RETURN_IF_ERROR(check_edges(options));
  if (!options.filter.preset.empty())
    RETURN_IF_ERROR(find_any_preset(options.filter.preset).status());
  return read_edits(options);
}

bool is_up_to_date(const FilterJob& job) {
  struct stat in, out;
  if (::stat(job.in.c_str(), &in) != 0 || ::stat(job.out.c_str(), &out) != 0) return false;
  const auto time = [](const timespec& of) { return std::pair(of.tv_sec, of.tv_nsec); };
  return time(out.st_mtim) > time(in.st_ctim);
}

FilterOutcome run_job(const FilterOptions& options, const std::vector<Edit>& edits,
                      const FilterJob& job) {
  namespace fs = std::filesystem;
  constexpr auto kTick = std::chrono::milliseconds(10);  // times of files are that much behind
  FilterOutcome outcome{job, FilterEnd::kDone, {}, {}};
  const auto begun = fs::file_time_type::clock::now() - kTick;
  std::error_code ignored;
  const bool is_there = options.no_clobber && fs::exists(job.out, ignored);
  if (is_there || (options.update && is_up_to_date(job))) {
    outcome.end = FilterEnd::kSkipped;
    return outcome;
  }
  auto facts = filtered(options, edits, job);
  if (facts.is_ok()) {
    outcome.facts = std::move(*facts);
    // A scan that was replaced meanwhile is newer than the result of the one before.
    if (job.out != kStandardStream) fs::last_write_time(job.out, begun, ignored);
  } else {
    outcome.end = FilterEnd::kFailed;
    outcome.status = facts.status();
  }
  return outcome;
}

}  // namespace burnish

// A folder whose files are filtered as they come.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "client/cli/commands.h"
#include "client/cli/filter/filter_run.h"
#include "client/cli/filter/watched_folder.h"
#include "client/cli/in_range.h"
#include "common/base/atomic_file.h"
#include "common/base/parallel.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kLook{5000};  // a share of another computer tells of no changes
constexpr milliseconds kRetryAfter{10'000};
constexpr int kTries = 3;
constexpr double kStillMax = 3600;  // seconds

struct WatchOptions {
  FilterOptions filter;
  std::string folder;
  double still = 2;  ///< seconds
  bool once = false;
};

/// The outcome of a file so far. It is forgotten when the file changes.
struct Attempts {
  WatchedFile file;
  int failures = 0;
  bool is_done = false;
  Clock::time_point next;
};

class Watch {
 public:
  Watch(const WatchOptions& options, std::vector<Edit> edits, WatchedFolder& folder)
      : options_(options), edits_(std::move(edits)), folder_(folder) {}

  /// Ends with --once alone; a signal may end the program at any time, since results appear whole.
  /// Fails: as the folder or a file does.
  Status run() {
    while (true) {
      const Status looked = look();
      if (options_.once && !folder_.has_moving()) return looked.is_ok() ? end() : looked;
      tell_of_folder(looked);
      folder_.wait(folder_.has_moving() ? still() : kLook);
    }
  }

 private:
  milliseconds still() const { return milliseconds(static_cast<int64_t>(1000 * options_.still)); }

  Status end() const {
    const auto failed =
        std::ranges::count_if(attempts_, [](const auto& of) { return of.second.failures > 0; });
    if (failed == 0) return Status::ok();
    return invalid_argument(std::to_string(failed) + (failed == 1 ? " file" : " files") +
                            " failed");
  }

  /// A share that is away for a while is said once.
  void tell_of_folder(const Status& looked) {
    if (looked.message() == told_.message()) return;
    if (!looked.is_ok()) std::cerr << "burnish: " << looked.message() << "\n";
    told_ = looked;
  }

  Status look() {
    ASSIGN_OR_RETURN(const std::vector<WatchedFile> files, folder_.still_files(still()));
    for (const WatchedFile& file : files)
      if (is_due(file)) work_off(file);
    return Status::ok();
  }

  FilterJob job_of(const WatchedFile& file) const {
    return {file.path.string(), name_in_folder(file.path.string(), options_.filter)};
  }

  int tries() const { return options_.once ? 1 : kTries; }

  /// A file that has changed since it was seen is due, whatever the times say.
  bool is_due(const WatchedFile& file) {
    Attempts& attempts = attempts_[file.path];
    const bool is_first_seen = attempts.file.path.empty();
    if (attempts.file != file) attempts = {file, 0, false, {}};
    if (is_first_seen) attempts.is_done = is_first_with_name(file) && is_up_to_date(job_of(file));
    return !attempts.is_done && attempts.failures < tries() && Clock::now() >= attempts.next;
  }

  /// Two files of one name and several formats may want one result.
  bool is_first_with_name(const WatchedFile& file) {
    const FilterJob job = job_of(file);
    std::string& first = writers_[job.out];
    std::error_code ignored;
    if (first.empty() || !fs::exists(first, ignored)) first = job.in;
    return first == job.in;
  }

  void work_off(const WatchedFile& file) {
    Attempts& attempts = attempts_[file.path];
    FilterOutcome outcome{job_of(file), FilterEnd::kFailed, {}, {}};
    if (is_first_with_name(file)) {
      outcome = run_job(options_.filter, edits_, outcome.job);
      if (outcome.end == FilterEnd::kFailed) write_report(outcome);
    } else {
      attempts.failures = tries();
      outcome.status = invalid_argument(writers_[outcome.job.out] + " has the name " +
                                        outcome.job.out + " already; rename one");
    }
    attempts.is_done = outcome.end != FilterEnd::kFailed;
    if (!attempts.is_done) {
      attempts.failures = std::min(attempts.failures + 1, tries());
      attempts.next = Clock::now() + kRetryAfter * attempts.failures;
    }
    tell(outcome, attempts);
  }

  void write_report(const FilterOutcome& outcome) {
    const Status reported = write_file(outcome.job.out + ".json", json_of(outcome) + "\n");
    if (!reported.is_ok()) std::cerr << "burnish: " << reported.message() << "\n";
  }

  void tell(const FilterOutcome& outcome, const Attempts& attempts) const {
    if (options_.filter.json) {
      std::cout << json_of(outcome) << std::endl;
    } else if (attempts.is_done) {
      print_outcome(outcome);
      std::cout << std::flush;
    }
    if (attempts.is_done) return;
    std::cerr << "burnish: " << outcome.job.in << " failed: " << outcome.status.message()
              << (attempts.failures == tries() ? "; it is left until it changes\n"
                                               : "; it is tried again\n");
  }

  const WatchOptions& options_;
  const std::vector<Edit> edits_;
  WatchedFolder& folder_;
  std::map<fs::path, Attempts> attempts_;
  std::map<std::string, std::string> writers_;  // IN by OUT
  Status told_ = Status::ok();
};

/// Fails: invalid_argument if the results would be filtered again; as the folders cannot be used.
Status check_folders(const WatchOptions& options) {
  RETURN_IF_ERROR(make_out_dir(options.filter));
  std::error_code error;
  if (!fs::equivalent(options.folder, options.filter.out_dir, error)) return Status::ok();
  return invalid_argument("IN_DIR and OUT_DIR are one folder, " + options.folder +
                          ": results would be filtered again");
}

Status watch(const WatchOptions& options) {
  ASSIGN_OR_RETURN(std::vector<Edit> edits, check_filter(options.filter));
  ASSIGN_OR_RETURN(const auto folder, WatchedFolder::open(options.folder));
  RETURN_IF_ERROR(check_folders(options));
  use_threads(options.filter.solver.threads);
  return Watch(options, std::move(edits), *folder).run();
}

}  // namespace

void add_watch_command(CommandTable& table) {
  const auto options = std::make_shared<WatchOptions>();
  FilterOptions& filter = options->filter;
  filter.reports = true;
  filter.force = true;  // files beside an older OUT
  CLI::App* command = table.add("watch", "Filter the files of a folder as they come",
                                [options] { return watch(*options); });
  command->add_option("IN_DIR", options->folder, "Folder into which scans are put")->required();
  command->add_option("OUT_DIR", filter.out_dir, "Folder for the results; it is made")->required();
  command->add_option("--to", filter.to, "Format of the results (default: IN's)")
      ->check(CLI::IsMember(mesh_format_names()));
  command
      ->add_option("--still", options->still,
                   "Seconds for which a file has not changed when it is whole")
      ->check(in_range(0.0, kStillMax))
      ->capture_default_str();
  command->add_flag("--once", options->once, "Filter what lies there, and end");
  command->add_flag("--json", filter.json, "Print a line of JSON for each file");
  add_work_options(*command, filter);
}

}  // namespace burnish

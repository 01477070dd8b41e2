#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/cli/filter/filter_options.h"
#include "common/base/status.h"

namespace burnish {

/// The word for standard input and standard output.
inline constexpr const char* kStandardStream = "-";

/// A file to filter.
struct FilterJob {
  std::string in, out;  ///< as the user names them
};

/// Returns the name of IN in the folder of the options, with their format.
std::string name_in_folder(const std::string& in, const FilterOptions& options);

/// Returns one job for IN and OUT, or one for each IN of a folder, in their order.
/// Fails: invalid_argument (too few files; two files that would have one name; '-' among several).
Result<std::vector<FilterJob>> plan_jobs(const FilterOptions& options);

/// The files of a job on disk. Standard input and output are files in a folder of their own, which
/// goes with this object.
class JobFiles {
 public:
  /// Reads standard input to its end, if the job says so. Fails: as errno says.
  static Result<JobFiles> open(const FilterJob& job, const FilterOptions& options);

  JobFiles(JobFiles&& other) noexcept = default;
  JobFiles& operator=(JobFiles&& other) = delete;
  ~JobFiles();

  const std::filesystem::path& in() const { return in_; }
  const std::filesystem::path& out() const { return out_; }

  /// Returns a failure with the names that the user knows for files of the folder.
  Status named(const FilterJob& job, const Status& status) const;

  /// Copies the written file to standard output, if the job says so. Fails: as errno says.
  Status finish(const FilterJob& job) const;

 private:
  JobFiles() = default;

  std::filesystem::path folder_;  // empty: none
  std::filesystem::path in_, out_;
};

}  // namespace burnish

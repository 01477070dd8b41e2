#pragma once

#include <string>
#include <vector>

#include "client/cli/filter/filter_file.h"
#include "client/cli/filter/filter_jobs.h"

namespace burnish {

/// How a job ended.
enum class FilterEnd { kDone, kSkipped, kFailed };

/// A job and its end.
struct FilterOutcome {
  FilterJob job;
  FilterEnd end = FilterEnd::kDone;
  Status status;        ///< of a job that failed
  FilteredFacts facts;  ///< of a job that is done
};

/// Prints a line for a file that is done or skipped: to standard output, or to standard error if
/// that has the mesh.
void print_outcome(const FilterOutcome& outcome);

/// Returns the outcome as JSON: what print_outcomes_json() prints of each.
std::string json_of(const FilterOutcome& outcome);

/// Prints all as JSON: {"files": [...]}, with "code" and "message" if the work did not begin.
void print_outcomes_json(const std::vector<FilterOutcome>& outcomes, const Status& begun);

/// Returns the Status of all: that of the only file, or how many failed.
Status status_of(const std::vector<FilterOutcome>& outcomes);

}  // namespace burnish

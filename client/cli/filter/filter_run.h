#pragma once

#include <vector>

#include "client/cli/filter/filter_jobs.h"
#include "client/cli/filter/filter_options.h"
#include "client/cli/filter/filter_outcomes.h"
#include "common/base/status.h"
#include "common/edit/edit.h"

namespace burnish {

/// Reads the edits of a run, and refuses what cannot work before the work begins. Fails: as the
/// filter's own files cannot be read; not_found for an unknown preset; unimplemented for what
/// cannot stand beside kept edges.
Result<std::vector<Edit>> check_filter(const FilterOptions& options);

/// Makes the folder for the files, if there is one. Fails: as errno says.
Status make_out_dir(const FilterOptions& options);

/// Returns whether OUT was begun after IN got its place and its content. A copy that keeps an old
/// time of its file counts as new.
bool is_up_to_date(const FilterJob& job);

/// Filters one file. The result has the time when its work began. A failure is in the outcome.
FilterOutcome run_job(const FilterOptions& options, const std::vector<Edit>& edits,
                      const FilterJob& job);

}  // namespace burnish

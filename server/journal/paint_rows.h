#pragma once

#include <string>
#include <vector>

#include "server/fields/paint_checkpoints.h"
#include "server/journal/group_commit.h"

namespace burnish {

// Kept paint, in a table `paint` of SQLite.

/// Keeps paint of a session; drops the oldest beyond a few. Does not wait, has its own commit, and
/// logs a failure.
void keep_paint_row(GroupCommit& commit, const std::string& session_id,
                    const PaintCheckpoint& paint);

/// Returns the kept paint, without damaged paint.
Result<std::vector<PaintCheckpoint>> read_paint_rows(GroupCommit& commit,
                                                     const std::string& session_id,
                                                     size_t cell_count);

}  // namespace burnish

#pragma once

#include <vector>

#include "server/journal/journal.h"

namespace burnish {

/// The edits that a fork begins with.
struct ForkedEdits {
  std::vector<AuthoredEdit> edits;
  uint64_t emptied = 0;  ///< edits that set single cells of the source, and set none of the fork
};

/// Returns whether both sessions have the same cells, and so the same paint.
bool has_same_cells(const SessionRecord& source, const SessionRecord& fork);

/// Takes the first `count` edits of all. Fails: data_loss if there are fewer.
Result<ForkedEdits> edits_of_fork(std::vector<AuthoredEdit> all, uint64_t count,
                                  const SessionRecord& source, const SessionRecord& fork);

}  // namespace burnish

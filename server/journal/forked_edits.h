#pragma once

#include <cstdint>
#include <vector>

#include "server/journal/journal.h"

namespace burnish {

/// Makes the edits of a fork from those of its source: the first `count`, without single cells if
/// the fork has another depth. Returns how many edits set cells before. Fails: data_loss (the
/// source has fewer edits).
Result<uint64_t> make_forked_edits(const SessionRecord& source, const SessionRecord& fork,
                                   uint64_t count, std::vector<AuthoredEdit>& edits);

/// Returns whether the fork has its source's cells, so that it can have its paint.
bool has_same_cells(const SessionRecord& source, const SessionRecord& fork);

}  // namespace burnish

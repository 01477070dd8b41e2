#include "server/journal/forked_edits.h"

namespace burnish {

bool has_same_cells(const SessionRecord& source, const SessionRecord& fork) {
  return source.key.depth == fork.key.depth;
}

/// Returns how many edits set cells before.
static uint64_t empty_cell_fields(std::vector<AuthoredEdit>& edits) {
  uint64_t emptied = 0;
  for (AuthoredEdit& each : edits) {
    auto* fields = std::get_if<SetCellFields>(&each.edit.change);
    if (fields == nullptr || fields->cells.empty()) continue;
    fields->cells.clear();
    ++emptied;
  }
  return emptied;
}

Result<ForkedEdits> edits_of_fork(std::vector<AuthoredEdit> all, uint64_t count,
                                  const SessionRecord& source, const SessionRecord& fork) {
  if (all.size() < count)
    return data_loss("the session's edits end at " + std::to_string(all.size()) + ", not at " +
                     std::to_string(count) + "; some were not written");
  ForkedEdits forked{std::move(all), 0};
  forked.edits.resize(count);
  if (!has_same_cells(source, fork)) forked.emptied = empty_cell_fields(forked.edits);
  return forked;
}

}  // namespace burnish

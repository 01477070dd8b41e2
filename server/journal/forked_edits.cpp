#include "server/journal/forked_edits.h"

#include <string>

namespace burnish {

bool has_same_cells(const SessionRecord& source, const SessionRecord& fork) {
  return source.key.depth == fork.key.depth;
}

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

Result<uint64_t> make_forked_edits(const SessionRecord& source, const SessionRecord& fork,
                                   uint64_t count, std::vector<AuthoredEdit>& edits) {
  if (edits.size() < count)
    return data_loss("the session's edits end at " + std::to_string(edits.size()) + ", not at " +
                     std::to_string(count) + "; some were not written");
  edits.resize(count);
  return has_same_cells(source, fork) ? 0 : empty_cell_fields(edits);
}

}  // namespace burnish

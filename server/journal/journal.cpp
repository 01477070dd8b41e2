#include "server/journal/journal.h"

#include <future>

namespace burnish {

WriteOutcome Journal::append(const std::string& session_id, uint64_t first,
                             std::vector<AuthoredEdit> edits) {
  std::promise<WriteOutcome> written;
  append(session_id, first, std::move(edits),
         [&](const WriteOutcome& outcome) { written.set_value(outcome); });
  return written.get_future().get();
}

Result<uint64_t> Journal::checkpoint(const std::string& session_id, const std::string& name) {
  ASSIGN_OR_RETURN(const auto edits, this->edits(session_id));
  for (size_t number = edits.size(); number > 0; --number) {
    const auto* change = std::get_if<SetCheckpoint>(&edits[number - 1].edit.change);
    if (change && change->name == name) return uint64_t{number};
  }
  return not_found("no checkpoint has the name '" + name + "'");
}

}  // namespace burnish

#include "server/journal/journal_copy.h"

namespace burnish {

static Result<KeptSession> read_whole(Journal& journal, const SessionRecord& record) {
  ASSIGN_OR_RETURN(auto roles, journal.roles(record.id));
  ASSIGN_OR_RETURN(auto edits, journal.edits(record.id));
  return KeptSession{record, std::move(roles), std::move(edits)};
}

static Status check_all(const std::vector<SessionRecord>& records) {
  for (const SessionRecord& record : records)
    if (record.is_damaged)
      return data_loss("session " + record.name + " (" + record.id +
                       "): its row in the journal is damaged; delete it or restore a backup");
  return Status::ok();
}

Result<JournalCopy> copy_journal(Journal& from, Journal& to) {
  ASSIGN_OR_RETURN(const auto present, to.sessions());
  if (!present.empty())
    return failed_precondition("the target has " + std::to_string(present.size()) +
                               " sessions already, such as " + present.front().name);
  ASSIGN_OR_RETURN(const auto records, from.sessions());
  RETURN_IF_ERROR(check_all(records));
  JournalCopy copied;
  const auto next = [&]() -> Result<std::optional<KeptSession>> {
    if (copied.sessions == records.size()) return std::optional<KeptSession>();
    ASSIGN_OR_RETURN(KeptSession session, read_whole(from, records[copied.sessions]));
    ++copied.sessions;
    copied.edits += session.edits.size();
    return std::optional(std::move(session));
  };
  RETURN_IF_ERROR(to.enter_all(next));
  return copied;
}

}  // namespace burnish

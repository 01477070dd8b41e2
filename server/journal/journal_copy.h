#pragma once

#include "server/journal/journal.h"

namespace burnish {

/// The counts of a copy.
struct JournalCopy {
  size_t sessions = 0;
  uint64_t edits = 0;
};

/// Copies all sessions with their roles and edits into a journal without sessions, in one
/// transaction. Needs: nobody else uses either. Fails: failed_precondition (the target has
/// sessions), data_loss (a session's row is damaged), as the journals say.
Result<JournalCopy> copy_journal(Journal& from, Journal& to);

}  // namespace burnish

#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "server/journal/postgres_rows.h"

namespace burnish {

/// The sessions that this server holds, as the database knows it.
struct Holdings {
  std::string life;                       ///< id of this server's life; empty without a node
  std::map<std::string, int64_t> epochs;  ///< by session

  Holding of(const std::string& session_id) const {
    const auto epoch = epochs.find(session_id);
    return {life, epoch == epochs.end() ? 0 : epoch->second};
  }
};

/// Edits for one session that belong together.
struct PendingAppend {
  std::string session_id;
  uint64_t first = 1;
  std::vector<AuthoredEdit> edits;
  Journal::Done done;
  std::optional<WriteOutcome> outcome;
};

/// Writes appends in one transaction, in their order. Where the server refuses one of them, does
/// each in a transaction of its own. Appends whose outcome another try may find out have none
/// afterwards; returns why then. An append that comes again is found in the database, if it was
/// written before.
Status write_appends(PgConnection& database, const Holdings& holdings,
                     std::span<PendingAppend> appends);

}  // namespace burnish

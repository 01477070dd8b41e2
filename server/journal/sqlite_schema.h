#pragma once

#include "server/journal/sqlite.h"

namespace burnish {

/// Makes the tables of a new journal, or updates those of an older program. Fails: data_loss for a
/// journal of a newer program; as SQLite says.
Status make_journal_schema(Database& database);

}  // namespace burnish

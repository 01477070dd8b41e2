#pragma once

#include <filesystem>

#include "server/journal/sqlite.h"

namespace burnish {

/// Returns whether a file is a journal of any version. Changes nothing. Fails: as SQLite says.
Result<bool> has_journal_schema(const std::filesystem::path& path);

/// Makes the tables of a new journal, or updates those of an older program. Fails: data_loss for a
/// journal of a newer program, or a database of another one; as SQLite says.
Status make_journal_schema(Database& database);

}  // namespace burnish

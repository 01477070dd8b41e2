#pragma once

#include <string>

#include "common/edit/edit.h"

namespace burnish {

// Edits of a journal whose rows are damaged or missing.

inline constexpr char kDamagedSessionRow[] =
    "the session's row in the journal (its name, scan and depth) is damaged; restore the journal "
    "from a backup";

/// Returns the id of a damaged edit's row. The space keeps it apart from all ids of clients.
std::string id_of_damaged(uint64_t number);

/// Returns the edit in place of a missing row.
AuthoredEdit missing_edit();

/// Reads a row's edit; a Damaged one if the row's checksum or the bytes are wrong.
void read_kept_edit(const std::string& bytes, bool is_checksum_right, Edit& edit);

}  // namespace burnish

#pragma once

struct sqlite3;

namespace burnish {

/// Gives a connection the SQL function row_checksum(VALUE, ...): 16 bytes, the XXH3-128 of the
/// values with their types and lengths. Journals keep what it returns, so that it never changes.
/// It finds damage, not forgery. False: out of memory.
bool add_row_checksum(sqlite3* database);

}  // namespace burnish

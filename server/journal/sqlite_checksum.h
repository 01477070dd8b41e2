#pragma once

struct sqlite3;

namespace burnish {

/// Adds the SQL function row_checksum(VALUE, ...) to a connection. It returns 16 bytes, the
/// XXH3-128 of the values with their types and lengths. Journals keep the result, so the function
/// must never change. It finds damage, not forgery. Returns false without memory.
bool add_row_checksum(sqlite3* database);

}  // namespace burnish

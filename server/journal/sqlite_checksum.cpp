#include "server/journal/sqlite_checksum.h"

#include <sqlite3.h>

#include "server/journal/row_checksum.h"

namespace burnish {

static std::string_view bytes_of(sqlite3_value* value) {
  const auto* bytes = static_cast<const char*>(sqlite3_value_blob(value));
  return {bytes, static_cast<size_t>(sqlite3_value_bytes(value))};
}

static void add_value(RowChecksum& sum, sqlite3_value* value) {
  switch (sqlite3_value_type(value)) {
    case SQLITE_INTEGER:
      return sum.add(int64_t{sqlite3_value_int64(value)});
    case SQLITE_FLOAT:
      return sum.add(sqlite3_value_double(value));
    case SQLITE_NULL:
      return sum.add_null();
    case SQLITE_TEXT:
      return sum.add_text(bytes_of(value));
    default:
      sum.add(bytes_of(value));
  }
}

static void row_checksum(sqlite3_context* context, int count, sqlite3_value** values) {
  auto& sum = *static_cast<RowChecksum*>(sqlite3_user_data(context));
  for (int i = 0; i < count; ++i) add_value(sum, values[i]);
  const std::string bytes = sum.take();
  sqlite3_result_blob(context, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
}

bool add_row_checksum(sqlite3* database) {
  const auto free_sum = [](void* kept) { delete static_cast<RowChecksum*>(kept); };
  // SQLite frees the sum, even if this fails.
  return sqlite3_create_function_v2(database, "row_checksum", -1,
                                    SQLITE_UTF8 | SQLITE_DETERMINISTIC, new RowChecksum,
                                    row_checksum, nullptr, nullptr, free_sum) == SQLITE_OK;
}

}  // namespace burnish

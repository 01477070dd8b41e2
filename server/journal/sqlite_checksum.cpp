#include "server/journal/sqlite_checksum.h"

#include <bit>
#include <cstdint>
#include <xxhash.h>

#include <sqlite3.h>

namespace burnish {

static_assert(std::endian::native == std::endian::little, "journals move between machines");

template <typename T>
static void add(XXH3_state_t* state, const T& value) {
  XXH3_128bits_update(state, &value, sizeof value);
}

static void add_value(XXH3_state_t* state, sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  add(state, static_cast<uint8_t>(type));
  switch (type) {
    case SQLITE_INTEGER:
      add(state, int64_t{sqlite3_value_int64(value)});
      return;
    case SQLITE_FLOAT:
      add(state, sqlite3_value_double(value) + 0.0);  // a table returns -0 as 0
      return;
    case SQLITE_NULL:
      return;
    default: {
      const void* bytes = sqlite3_value_blob(value);
      const auto size = static_cast<uint64_t>(sqlite3_value_bytes(value));
      add(state, size);
      if (size > 0) XXH3_128bits_update(state, bytes, size);
    }
  }
}

static void row_checksum(sqlite3_context* context, int count, sqlite3_value** values) {
  auto* state = static_cast<XXH3_state_t*>(sqlite3_user_data(context));
  XXH3_128bits_reset(state);
  for (int i = 0; i < count; ++i) add_value(state, values[i]);
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, XXH3_128bits_digest(state));
  sqlite3_result_blob(context, bytes.digest, sizeof bytes.digest, SQLITE_TRANSIENT);
}

bool add_row_checksum(sqlite3* database) {
  XXH3_state_t* state = XXH3_createState();
  if (!state) return false;
  const auto free_state = [](void* kept) { XXH3_freeState(static_cast<XXH3_state_t*>(kept)); };
  // SQLite frees the state, even if this fails.
  return sqlite3_create_function_v2(database, "row_checksum", -1,
                                    SQLITE_UTF8 | SQLITE_DETERMINISTIC, state, row_checksum,
                                    nullptr, nullptr, free_state) == SQLITE_OK;
}

}  // namespace burnish

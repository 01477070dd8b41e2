// Loaded into a burnish-server under test (LD_PRELOAD): a server without the fence. Its appends go
// to the end of the session's edits, whoever has the session. The tests show with it that they
// notice.

#include <cstring>
#include <dlfcn.h>
#include <string>

static void replace(std::string& text, const char* part, const char* by) {
  const size_t at = text.find(part);
  if (at != std::string::npos) text.replace(at, std::strlen(part), by);
}

// The types of libpq, as its header says: a connection is a pointer.
extern "C" int PQsendQueryParams(void* connection, const char* command, int count,
                                 const unsigned* types, const char* const* values,
                                 const int* lengths, const int* formats, int result_format) {
  using Send = int (*)(void*, const char*, int, const unsigned*, const char* const*, const int*,
                       const int*, int);
  static const auto real = reinterpret_cast<Send>(::dlsym(RTLD_NEXT, "PQsendQueryParams"));
  std::string text = command;
  if (text.starts_with("WITH held AS (UPDATE sessions SET edits = $2")) {
    replace(text, "SET edits = $2", "SET edits = edits + 1");
    replace(text, "AND edits = $2 - 1", "AND $2 > 0");
    replace(text, "AND epoch = $4", "AND $4 > 0");
    replace(text, "AND owner IS NOT DISTINCT FROM CAST(NULLIF($3, '') AS uuid)",
            "AND $3 IS NOT NULL");
    replace(text, "RETURNING id", "RETURNING edits");
    replace(text, "SELECT $1, $2, $4", "SELECT $1, held.edits, $4");
  }
  return real(connection, text.c_str(), count, types, values, lengths, formats, result_format);
}

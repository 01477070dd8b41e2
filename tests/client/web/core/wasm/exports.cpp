// The checks as a module for Node: no page, no worker.

#include <cstdlib>
#include <string>

#include "tests/client/web/core/wasm/checks.h"

#define BURNISH_EXPORT(name) __attribute__((visibility("default"), export_name(#name)))

extern "C" {

BURNISH_EXPORT(take) uint8_t* take(size_t bytes) {
  return static_cast<uint8_t*>(std::malloc(bytes + 1));
}

/// Writes the answer over the bytes. Needs: memory of take(), with room for it. Returns its length.
BURNISH_EXPORT(answer)
size_t answer(const char* kind, uint8_t* bytes, size_t count, char* to, size_t room) {
  const std::string text = burnish::answer_of(kind, {bytes, count});
  return text.copy(to, room);
}

}  // extern "C"

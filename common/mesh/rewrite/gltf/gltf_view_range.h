#pragma once

#include <cstdint>

#include "common/gltf/json_access.h"

namespace burnish {

/// Private to this folder. Returns a member that is a whole number, else `absent`.
inline uint64_t whole_or(const GltfJson& object, const char* name, uint64_t absent) {
  const auto number = read_whole(object, name, "", absent);
  return number.is_ok() ? *number : absent;
}

/// Private to this folder. The bytes of a buffer view, or of what an extension says in its place.
/// One that says nothing of the kind has none.
struct GltfViewRange {
  uint64_t buffer = 0, begin = 0, end = 0;

  explicit GltfViewRange(const GltfJson& view)
      : buffer(whole_or(view, "buffer", UINT64_MAX)),
        begin(whole_or(view, "byteOffset", 0)),
        end(begin + whole_or(view, "byteLength", 0)) {}

  bool meets(const GltfViewRange& other) const {
    return buffer == other.buffer && begin < other.end && other.begin < end;
  }
};

}  // namespace burnish

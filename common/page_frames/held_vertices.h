#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace burnish {

/// The vertices of a page that stay where they are, whatever a frame's values say: a bit each, the
/// first vertex's lowest in the first byte. Null: none. Values of kind corners cannot say it, since
/// vertices that move have the same corners.
using HeldVertices = std::shared_ptr<const std::vector<uint8_t>>;

/// Returns the bytes that say it of a page.
inline size_t held_bytes(size_t vertices) {
  return (vertices + 7) / 8;
}

inline bool is_same(const HeldVertices& a, const HeldVertices& b) {
  return a == b || (a && b && *a == *b);
}

/// Calls visit(vertex), rising.
template <typename Visit>
void for_each_held(const HeldVertices& held, const Visit& visit) {
  if (!held) return;
  for (size_t byte = 0; byte < held->size(); ++byte)
    for (unsigned bits = (*held)[byte]; bits != 0; bits &= bits - 1)
      visit(8 * byte + static_cast<size_t>(std::countr_zero(bits)));
}

}  // namespace burnish

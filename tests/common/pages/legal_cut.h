#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "common/pages/directory.h"

namespace burnish {

/// Returns whether every coarser page of a page in the set is in the set. The empty set is legal
/// and shows nothing; any other holds the root. Shapes: one byte per page.
inline bool is_legal_cut(const PageDirectory& directory, std::span<const uint8_t> set) {
  for (PageId page = 0; page < set.size(); ++page) {
    if (set[page] == 0) continue;
    const auto coarser = directory.coarser[page];
    if (std::ranges::any_of(coarser, [&](PageId other) { return set[other] == 0; })) return false;
  }
  return true;
}

/// Adds what the set lacks to be a legal cut. Shapes: one byte per page. Cost: O(pages + links).
inline void close_cut(const PageDirectory& directory, std::span<uint8_t> set) {
  for (PageId page = 0; page < set.size(); ++page)
    if (set[page] != 0)
      for (const PageId coarser : directory.coarser[page]) set[coarser] = 1;
}

}  // namespace burnish

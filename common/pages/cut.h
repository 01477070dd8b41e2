#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/pages/directory.h"

namespace burnish {

/// A set of pages: one byte per page of the directory, 0 for those outside. Bytes, since threads
/// may write them side by side.
using PageSet = std::vector<uint8_t>;

/// Returns whether every coarser page of a page in the set is in the set. A picture of such a set
/// is a whole surface. The empty set is legal and shows nothing; any other holds the root.
/// Shapes: one byte per page.
bool is_legal_cut(const PageDirectory& directory, std::span<const uint8_t> set);

/// Adds what the set lacks to be a legal cut. Shapes: one byte per page. Cost: O(pages + links).
void close_cut(const PageDirectory& directory, std::span<uint8_t> set);

/// Returns whether the picture of a set draws a patch of a page in the set.
inline bool is_drawn(const PagePatch& patch, std::span<const uint8_t> set) {
  return patch.finer == kNoPage || set[patch.finer] == 0;
}

}  // namespace burnish

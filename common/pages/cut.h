#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/pages/page.h"

namespace burnish {

/// A set of pages: one byte per page of the directory, 0 for those outside. Bytes, since threads
/// may write them side by side. A picture of a set is a whole surface if the set holds every
/// coarser page of its pages.
using PageSet = std::vector<uint8_t>;

/// Returns whether the picture of a set draws a patch of a page in the set.
inline bool is_drawn(const PagePatch& patch, std::span<const uint8_t> set) {
  return patch.finer == kNoPage || set[patch.finer] == 0;
}

}  // namespace burnish

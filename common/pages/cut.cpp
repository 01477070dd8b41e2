#include "common/pages/cut.h"

#include <algorithm>

namespace burnish {

bool is_legal_cut(const PageDirectory& directory, std::span<const uint8_t> set) {
  for (PageId page = 0; page < set.size(); ++page) {
    if (set[page] == 0) continue;
    const auto coarser = directory.coarser[page];
    if (std::ranges::any_of(coarser, [&](PageId other) { return set[other] == 0; })) return false;
  }
  return true;
}

void close_cut(const PageDirectory& directory, std::span<uint8_t> set) {
  for (PageId page = 0; page < set.size(); ++page)
    if (set[page] != 0)
      for (const PageId coarser : directory.coarser[page]) set[coarser] = 1;
}

}  // namespace burnish

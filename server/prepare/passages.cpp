#include "server/prepare/passages.h"

#include <utility>

namespace burnish {

void ColumnsAround::move_to(const CellColumn& column) {
  near_count_ = 0;
  for (int dx = -1; dx <= 1; ++dx) {
    const std::pair first(column.i + dx, column.j - 1), last(column.i + dx, column.j + 1);
    const auto place = [&](size_t c) { return std::pair(columns_[c].i, columns_[c].j); };
    size_t& row = row_[dx + 1];
    while (row < columns_.size() && place(row) < first) ++row;
    for (size_t c = row; c < columns_.size() && place(c) <= last; ++c)
      near_[near_count_++] = {columns_[c].k, slot_of_offset(dx, columns_[c].j - column.j, -1)};
  }
}

Passages ColumnsAround::passages(int k) const {
  constexpr int kStep = slot_of_offset(0, 0, 1) - slot_of_offset(0, 0, 0);
  Passages found = 0;
  for (int n = 0; n < near_count_; ++n) {
    const auto& [range, lowest_slot] = near_[n];
    for (int dz = -1; dz <= 1; ++dz)
      if (k + dz >= range.first && k + dz <= range.last)
        found |= Passages{1} << (lowest_slot + (dz + 1) * kStep);
  }
  return found & kAllPassages;
}

}  // namespace burnish

#pragma once

namespace burnish {

/// Neighbour slot of an offset in {-1, 0, 1}³; the corner itself is slot 13.
inline constexpr int kSlots = 27;
inline constexpr int kSelfSlot = 13;
inline constexpr int slot_of_offset(int dx, int dy, int dz) {
  return (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1);
}
inline constexpr int opposite_slot(int slot) {
  return kSlots - 1 - slot;
}
/// Returns the slot of local corner b seen from local corner a of the same cell.
inline constexpr int slot_between(int a, int b) {
  return slot_of_offset((b & 1) - (a & 1), (b >> 1 & 1) - (a >> 1 & 1), (b >> 2) - (a >> 2));
}

}  // namespace burnish

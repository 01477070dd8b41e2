#include "common/page_frames/page_steps.h"

#include <cstddef>

#include "common/packing/zigzag.h"

namespace burnish {

bool code_page(std::span<const int32_t> wanted, int shift, std::span<int32_t> values,
               std::span<uint32_t> residuals) {
  const size_t size = wanted.size() / 3;
  uint32_t changed = 0;
  for (int axis = 0; axis < 3; ++axis) {
    uint32_t before = 0;
    for (size_t i = axis * size; i < (axis + 1) * size; ++i) {
      const int32_t steps = round_to_step(wanted[i], shift);
      const int32_t old = round_to_step(values[i], shift);
      const uint32_t k = static_cast<uint32_t>(steps) - static_cast<uint32_t>(old);
      residuals[i] = to_zigzag(k - before);
      before = k;
      const int32_t fresh = value_of_step(steps, shift);
      changed |= static_cast<uint32_t>(fresh ^ values[i]);
      values[i] = fresh;
    }
  }
  return changed != 0;
}

void undo_page(std::span<const uint32_t> residuals, int shift, std::span<int32_t> values) {
  const size_t size = residuals.size() / 3;
  for (int axis = 0; axis < 3; ++axis) {
    uint32_t k = 0;
    for (size_t i = axis * size; i < (axis + 1) * size; ++i) {
      k += from_zigzag(residuals[i]);
      const auto old = static_cast<uint32_t>(round_to_step(values[i], shift));
      values[i] = value_of_step(static_cast<int32_t>(old + k), shift);
    }
  }
}

}  // namespace burnish

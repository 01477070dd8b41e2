#include "common/packing/narrow_values.h"

#include <algorithm>
#include <limits>

namespace burnish {

static bool fits_narrow(std::span<const int32_t> values) {
  uint32_t outside = 0;
  for (const int32_t value : values) outside |= static_cast<uint32_t>(value) + 0x8000u;
  return outside <= std::numeric_limits<uint16_t>::max();
}

NarrowValues::NarrowValues(std::span<const int32_t> values) {
  if (fits_narrow(values))
    narrow_.assign(values.begin(), values.end());
  else
    wide_.assign(values.begin(), values.end());
}

void NarrowValues::read(std::span<int32_t> values) const {
  if (wide_.empty())
    std::ranges::copy(narrow_, values.begin());
  else
    std::ranges::copy(wide_, values.begin());
}

uint64_t NarrowValues::byte_count() const {
  return sizeof(*this) + narrow_.size() * sizeof(narrow_[0]) + wide_.size() * sizeof(wide_[0]);
}

}  // namespace burnish

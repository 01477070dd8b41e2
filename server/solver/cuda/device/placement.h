#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace burnish {

/// Returns the device for the next session: the first of those with the least bytes. Bytes also
/// measure work, because a session's step takes time by its corners. Needs: a device.
inline int least_loaded(std::span<const uint64_t> bytes_by_device) {
  return static_cast<int>(std::ranges::min_element(bytes_by_device) - bytes_by_device.begin());
}

}  // namespace burnish

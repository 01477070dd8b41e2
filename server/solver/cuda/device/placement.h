#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace burnish {

/// Where the next session goes, by the bytes that each device holds: the least, the first of
/// equals. Bytes stand for work as well: a session's step takes time by its corners. Needs: a
/// device.
inline int least_loaded(std::span<const uint64_t> bytes_by_device) {
  return static_cast<int>(std::ranges::min_element(bytes_by_device) - bytes_by_device.begin());
}

}  // namespace burnish

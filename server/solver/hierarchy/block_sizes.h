#pragma once

#include <cstdint>

namespace burnish {

/// The blocks of touched_blocks.h: parts that a device makes together, and cells whose inverses it
/// makes together.
inline constexpr int32_t kPartsOfBlock = 16;
inline constexpr int32_t kCellsOfBlock = 128;

}  // namespace burnish

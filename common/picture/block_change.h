#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace burnish {

/// A block of 8 x 8 numbers, row by row.
using Block8 = std::array<float, 64>;

/// Private to this folder. Adds a change of samples to the coefficients of a JPEG block. The
/// transform is linear, so samples need not be known: a coefficient whose change rounds to nothing
/// keeps its value. `steps` are the block's quantisation steps, in the order of `coefficients`: row
/// by row. Source: ISO/IEC 10918-1, A.3.3 and A.3.4.
void add_to_block(const Block8& samples, std::span<const uint16_t, 64> steps,
                  std::span<int16_t, 64> coefficients);

}  // namespace burnish

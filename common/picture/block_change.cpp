#include "common/picture/block_change.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {

static constexpr int kSide = 8;
static constexpr int kCoefficientMax = 1023;  // Huffman tables of 8-bit pictures end there

/// Returns the matrix of the transform along one axis: frequency by place.
static Block8 make_cosines() {
  Block8 cosines;
  for (int frequency = 0; frequency < kSide; ++frequency)
    for (int place = 0; place < kSide; ++place) {
      const double scale = frequency == 0 ? std::numbers::sqrt2 / 4 : 0.5;
      const double angle = (2 * place + 1) * frequency * std::numbers::pi / (2 * kSide);
      cosines[kSide * frequency + place] = static_cast<float>(scale * std::cos(angle));
    }
  return cosines;
}

static Block8 transposed(const Block8& matrix) {
  Block8 result;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      result[kSide * column + row] = matrix[kSide * row + column];
  return result;
}

static Block8 product(const Block8& left, const Block8& right) {
  Block8 result = {};
  for (int row = 0; row < kSide; ++row)
    for (int k = 0; k < kSide; ++k)
      for (int column = 0; column < kSide; ++column)
        result[kSide * row + column] += left[kSide * row + k] * right[kSide * k + column];
  return result;
}

void add_to_block(const Block8& samples, std::span<const uint16_t, 64> steps,
                  std::span<int16_t, 64> coefficients) {
  static const Block8 kCosines = make_cosines(), kTransposed = transposed(kCosines);
  const Block8 change = product(product(kCosines, samples), kTransposed);
  for (size_t i = 0; i < change.size(); ++i) {
    if (steps[i] == 0) continue;  // of a damaged file: no coefficient counts
    const float part = change[i] / steps[i];
    if (std::abs(part) < 0.5F) continue;
    const auto rounded = static_cast<int>(part + (part > 0 ? 0.5F : -0.5F));
    coefficients[i] = static_cast<int16_t>(
        std::clamp(coefficients[i] + rounded, -kCoefficientMax, kCoefficientMax));
  }
}

}  // namespace burnish

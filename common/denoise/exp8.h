#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "common/base/dispatch.h"
#include "common/denoise/filter_constants.h"

namespace burnish {

/// Replaces x by e^x for x of -40 to 0, and by e^-40 below, within 3e-7 of the value. The same bits
/// on every machine, other than libm's.
[[gnu::always_inline]] inline void exp8(Float8& x) {
  using Bits8 = uint32_t __attribute__((vector_size(32)));
  constexpr float kRounding = 0x1.8p23f;  // its sum with a small number has no fraction
  constexpr float kLog2OfE = 1.44269504f, kLn2 = 0.693359375f, kLn2Rest = -2.12194440e-4f;
  x = x < kExponentMin ? Float8{} + kExponentMin : x;
  const Float8 shifted = x * kLog2OfE + kRounding;
  const Float8 whole = shifted - kRounding;
  const Float8 r = x - whole * kLn2 - whole * kLn2Rest;
  Float8 sum = r * (1.f / 720) + 1.f / 120;
  sum = sum * r + 1.f / 24;
  sum = sum * r + 1.f / 6;
  sum = sum * r + 0.5f;
  sum = sum * r + 1.f;
  sum = sum * r + 1.f;
  const Bits8 power = ((Bits8)shifted << 23) + 0x3f800000u;  // 2 to the whole part
  x = sum * (Float8)power;
}

/// Replaces each value by its exp8().
[[gnu::always_inline]] inline void exp_in_place(float* values, size_t count) {
  for (size_t i = 0; i < count; i += 8) {
    Float8 x = {};
    const size_t bytes = std::min<size_t>(8, count - i) * sizeof(float);
    if (bytes == sizeof x) {
      std::memcpy(&x, values + i, sizeof x);
      exp8(x);
      std::memcpy(values + i, &x, sizeof x);
    } else {
      std::memcpy(&x, values + i, bytes);
      exp8(x);
      std::memcpy(values + i, &x, bytes);
    }
  }
}

}  // namespace burnish

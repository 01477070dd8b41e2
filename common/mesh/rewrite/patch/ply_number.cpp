#include "common/mesh/rewrite/patch/ply_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace burnish {

/// Calls `use` with a value of the C++ type that a PLY type stands for.
template <typename Use>
static auto with_type(PlyType type, const Use& use) {
  switch (type) {
    case PlyType::kInt8:
      return use(int8_t{});
    case PlyType::kUint8:
      return use(uint8_t{});
    case PlyType::kInt16:
      return use(int16_t{});
    case PlyType::kUint16:
      return use(uint16_t{});
    case PlyType::kInt32:
      return use(int32_t{});
    case PlyType::kUint32:
      return use(uint32_t{});
    case PlyType::kFloat32:
      return use(float{});
    case PlyType::kFloat64:
      break;
  }
  return use(double{});
}

double kept_by(PlyType type, double value) {
  return with_type(type, [value](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_integral_v<T>) {
      constexpr double kLowest = std::numeric_limits<T>::lowest();
      return std::clamp(std::round(value), kLowest, double{std::numeric_limits<T>::max()});
    } else {
      return static_cast<double>(static_cast<T>(value));
    }
  });
}

std::string ply_number(PlyType type, PlyEncoding encoding, double value) {
  return with_type(type, [&](auto zero) -> std::string {
    using T = decltype(zero);
    const auto number = static_cast<T>(value);
    if (encoding == PlyEncoding::kAscii) {
      char text[32];
      return {text, std::to_chars(text, text + sizeof text, number).ptr};
    }
    std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
    if (encoding == PlyEncoding::kBigEndian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  });
}

}  // namespace burnish

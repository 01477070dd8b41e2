#pragma once

namespace burnish {

inline constexpr int kCornersPerCell = 8;
inline constexpr int kPairsPerCell = 28;  ///< pairs of different corners

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// Appends a polygon as the fan around its first corner: n corners, n - 2 triangles.
/// Needs: at least three corners.
inline void append_fan(std::span<const uint32_t> corners, std::vector<Triangle>& triangles) {
  for (size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

/// "face 3 has 2 corners; a face needs at least 3".
inline std::string corner_count_complaint(uint64_t face, int64_t corners) {
  return "face " + std::to_string(face) + " has " + std::to_string(corners) +
         " corners; a face needs at least 3";
}

/// "face 3 refers to vertex 9, but there are 8 (0 to 7)".
inline std::string index_complaint(const char* element, uint64_t number, int64_t index,
                                   uint64_t vertices) {
  return std::string(element) + " " + std::to_string(number) + " refers to vertex " +
         std::to_string(index) + ", but there are " + std::to_string(vertices) +
         ", numbered from 0";
}

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/base/types.h"

namespace burnish {

/// Appends a polygon as the fan around its first corner: n corners, n - 2 triangles.
/// Fewer than three corners give none.
template <typename Triangles>
void append_fan(std::span<const uint32_t> corners, Triangles& triangles) {
  for (size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

/// A strip in which each vertex makes a triangle with the two before it; every other triangle is
/// reversed. Triangles that repeat a vertex are joints of the strip and are left out.
class TriangleStrip {
 public:
  template <typename Triangles>
  void append(uint32_t c, Triangles& triangles) {
    ++length_;
    if (length_ >= 3 && a_ != b_ && b_ != c && c != a_)
      triangles.push_back(length_ % 2 == 1 ? Triangle{a_, b_, c} : Triangle{b_, a_, c});
    a_ = b_;
    b_ = c;
  }

 private:
  uint64_t length_ = 0;
  uint32_t a_ = 0;  // the vertex before the last
  uint32_t b_ = 0;  // the last
};

/// Limits how many bytes of triangles polygons and strips unfold to. Scans never come near this
/// limit; a hostile file with polygons around few vertices could fill the memory.
inline constexpr uint64_t kUnfoldedBytesPerFileByte = 4;
inline constexpr uint64_t kUnfoldedBytesInAnyCase = 1 << 20;

template <typename Triangles>
bool unfolds_too_far(const Triangles& triangles, uint64_t file_bytes) {
  return triangles.size() * sizeof(Triangle) >
         kUnfoldedBytesInAnyCase + kUnfoldedBytesPerFileByte * file_bytes;
}

template <typename Triangles>
std::string unfolding_complaint(const Triangles& triangles, uint64_t file_bytes) {
  return "the polygons so far are " + std::to_string(triangles.size()) +
         " triangles, which take more than " + std::to_string(kUnfoldedBytesPerFileByte) +
         " times the " + std::to_string(file_bytes) + " bytes of the file";
}

/// "face 3 refers to vertex 9, but there are 8, numbered from 0".
inline std::string index_complaint(const std::string& element, uint64_t number,
                                   const std::string& index, uint64_t vertices) {
  return element + " " + std::to_string(number) + " refers to vertex " + index +
         ", but there are " + std::to_string(vertices) + ", numbered from 0";
}

}  // namespace burnish

#pragma once

#include <span>

namespace burnish {

/// How many texels of pictures triangles show, and where pages end for them.
struct PageTexels {
  std::span<const float> of_triangle;  ///< empty: they do not matter
  double of_page_max = 0;              ///< of a page of several triangles

  bool matter() const { return !of_triangle.empty(); }
};

}  // namespace burnish

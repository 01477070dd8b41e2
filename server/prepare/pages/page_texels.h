#pragma once

#include <span>
#include <vector>

namespace burnish {

/// How many texels of pictures triangles show, and where pages end for them.
struct PageTexels {
  std::span<const float> of_triangle;  ///< empty: they do not matter
  double of_page_max = 0;              ///< of a page of several triangles

  bool matter() const { return !of_triangle.empty(); }
};

/// A triangle that shows texels.
struct TexelsOnArea {
  double texels = 0;  ///< positive
  double area = 0;    ///< positive, in any unit
};

/// Returns the density of texels that a page needs, for one unit of length: the mean of its
/// triangles, or that which all but a few texels have where some parts are much denser than others.
/// Returns 0 without a triangle.
double needed_texel_density(std::vector<TexelsOnArea> triangles);

/// Triangles count as at least so large, steps², so that densities are finite.
inline constexpr double kTriangleAreaMin = 0.5;

}  // namespace burnish

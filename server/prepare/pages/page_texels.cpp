#include "server/prepare/pages/page_texels.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace burnish {

// A part of the texels that may be denser than their page. Few triangles with far too many texels
// are mostly mistakes of a program that flattened the surface.
static constexpr double kPartDenser = 0.05;
// Times the mean. Less is hardly seen, and costs texels: the pictures of a cube on a ball, whose
// pages have up to 1.45, take 5.2 texels for one at 1.25.
static constexpr double kMuchDenser = 1.45;

static double density_of(const TexelsOnArea& triangle) {
  return std::sqrt(triangle.texels / triangle.area);
}

double needed_texel_density(std::vector<TexelsOnArea> triangles) {
  TexelsOnArea sum;
  for (const TexelsOnArea& triangle : triangles) {
    sum.texels += triangle.texels;
    sum.area += triangle.area;
  }
  if (!(sum.area > 0)) return 0;
  const double mean = density_of(sum);
  std::ranges::sort(triangles, std::greater(), density_of);
  double denser = 0;
  for (const TexelsOnArea& triangle : triangles) {
    denser += triangle.texels;
    if (denser <= kPartDenser * sum.texels) continue;
    return density_of(triangle) > kMuchDenser * mean ? density_of(triangle) : mean;
  }
  return mean;
}

}  // namespace burnish

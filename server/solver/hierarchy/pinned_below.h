#pragma once

namespace burnish {

/// A corner is pinned if its diagonal is below this part of the median one. It then has next to no
/// surface, and floats could not invert its diagonal. The bound is small, because a sliver h cells
/// wide has corners whose diagonal is h⁴ of the others': these move its vertices by all that the
/// surface turns or stretches along the sliver. With 1e-12 a torn wall is up to 8e-5 of the
/// diagonal off at a contrast of 1000, and the median that a sample of the corners has decides
/// where.
inline constexpr double kPinnedBelow = 1e-16;

}  // namespace burnish

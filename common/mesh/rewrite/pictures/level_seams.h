#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/record.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/rewrite/moved/seam_wish.h"
#include "common/mesh/textures/surface_textures.h"

namespace burnish {

/// No texel becomes more than so many times as bright or as dark where seams are levelled.
inline constexpr float kSeamFactorMax = 4;
/// Sides of a seam that differ by more levels of a byte, in one channel, show different things:
/// they are not made alike.
inline constexpr double kSeamStepMax = 60;

/// The steps of brightness at a scan's seams: per edge the mean difference of red, green and blue.
/// Units: levels of a byte.
struct SeamReport {
  uint32_t charts = 0;
  uint64_t edges = 0;     ///< that were measured
  uint64_t unknowns = 0;  ///< of the system that was solved
  double median_before = 0, median_after = 0;
};
BURNISH_RECORD(SeamReport, charts, edges, unknowns, median_before, median_after)

/// "seams of 12 charts levelled: median step 28.7 to 6.8 of 255", or "no seam between charts to
/// level".
std::string text_of(const SeamReport& report);

/// Factors of texels that level the seams of a scan.
struct LevelledSeams {
  std::vector<uint32_t> points;  ///< of corners, as TextureCharts::points
  std::vector<Vec3f> factors;    ///< per point, for red, green and blue in linear light
  SeamReport report;

  Vec3f factor(uint32_t triangle, size_t corner) const {
    const uint32_t point = points[3 * size_t{triangle} + corner];
    return point == kNoTexture ? Vec3f::Ones() : factors[point];
  }
  bool changes(uint32_t triangle) const;
  uint64_t byte_count() const {
    return points.size() * sizeof(uint32_t) + factors.size() * sizeof(Vec3f);
  }
};

/// Finds factors that level the borders between the charts of a scan's pictures, which photos of
/// different exposure leave. The logarithm of a factor is an unknown at each point of each chart.
/// Least squares: differences across seam edges become zero (weight 1), neighbours in a chart are
/// alike (0.1), nothing changes (1e-4). Conjugate gradients solve it. Steps above kSeamStepMax do
/// not count. Between the corners of a triangle factors are linear.
///
/// Fails: resource_exhausted; cancelled; as the budget does, which hears the memory first. The same
/// bits for any number of threads. Cost: 100 k unknowns take about a second, beside the reading of
/// the pictures.
Result<LevelledSeams> level_seams(const TexturedSurface& surface, const SeamWish& wish,
                                  const FileBudget& budget = {});

}  // namespace burnish

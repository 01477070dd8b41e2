#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/rewrite/pictures/texture_charts.h"

namespace burnish {

/// The colours at points along both sides of seams.
struct SeamSamples {
  static constexpr uint32_t kPerEdge = 4;

  /// The light of red, green and blue, 0 to 1; below 0: unknown. Shapes: kPerEdge per side, two
  /// sides per edge.
  std::vector<Vec3f> lights;

  static size_t index(size_t edge, size_t side, uint32_t sample) {
    return (2 * edge + side) * kPerEdge + sample;
  }
  /// Returns how far a sample is from the first end of its edge, of 0 to 1.
  static double part(uint32_t sample) { return (sample + 0.5) / kPerEdge; }
};

/// Reads the colours at seams from the pictures, linear between texels, half a texel inside of the
/// triangles: farther out there may be anything. A picture that is missing, damaged or repeats has
/// unknown colours. Pictures are decoded row by row. `others_bytes`: memory that is taken already,
/// for the budget. Fails: resource_exhausted; cancelled; as the budget does.
Result<SeamSamples> sample_seams(const TexturedSurface& surface, std::span<const SeamEdge> seams,
                                 uint64_t others_bytes, const FileBudget& budget);

}  // namespace burnish

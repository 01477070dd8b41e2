#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "server/prepare/pages/cut_pages.h"

namespace burnish {

/// A triangle's place: the sum of its corners, which is three times its centroid, in steps.
struct TriangleCentre {
  std::array<int32_t, 3> at;
  uint32_t triangle;
};

/// The triangles of a level in runs that are next to each other in space.
struct TriangleRuns {
  ScratchArray<TriangleCentre> centres;
  std::vector<uint64_t> starts;  ///< runs + 1, into `centres`
};

/// Deals triangles into runs of some kTrianglesPerRun along a Morton curve. The curve is shifted
/// from level to level. A run is what a machine with little memory must hold at once.
/// Deterministic: the same runs for any number of threads. Throws: WorkCancelled.
TriangleRuns make_triangle_runs(const LevelToCut& level, const ScratchSpace& space,
                                const LoopPart& part);

inline constexpr size_t kTrianglesPerRun = 1 << 18;

}  // namespace burnish

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "common/base/record.h"
#include "common/base/types.h"

namespace burnish {

/// Moves along an axis of the coordinates, by their sign. Averages are over the surface before.
struct AxisMoves {
  double least = 0;  ///< at most 0
  double most = 0;   ///< at least 0
  double mean = 0;
  double rms = 0;  ///< root of the mean of their squares

  double farthest() const { return most >= -least ? most : least; }
  /// Returns the same moves along the opposite axis.
  AxisMoves reversed() const { return {-most, -least, -mean, rms}; }
};

BURNISH_RECORD(AxisMoves, least, most, mean, rms)

/// How far an edit moved a surface. Lengths in file units; averages over the surface before. A
/// vertex stands for a third of the area of its triangles. Its normal is that of
/// least_that_agree(): a scan and the same scan as a soup have the same deviation.
struct Deviation {
  static constexpr int kBins = 64;

  double max = 0;                  ///< the longest way of a vertex
  Vec3d farthest = Vec3d::Zero();  ///< where this vertex was before
  double mean = 0;                 ///< of the lengths of the ways
  double rms = 0;                  ///< root of the mean of their squares
  double outward_max = 0;          ///< the largest move along the normal
  double inward_max = 0;           ///< the largest move against the normal; not negative
  double mean_along_normal = 0;    ///< outward moves count positive
  double area_before = 0;          ///< file units squared
  double area_after = 0;
  double volume_before = 0;  ///< file units cubed; means something for closed surfaces only
  double volume_after = 0;
  double histogram_range = 0;                ///< bins are even from -range to range
  std::array<double, kBins> histogram = {};  ///< fraction of the area by its move along the normal
  /// Along x, y and z; nothing from an older server.
  std::optional<std::array<AxisMoves, 3>> axes;

  /// A way of no length anywhere.
  bool is_zero() const { return max == 0; }
};

BURNISH_RECORD(Deviation, max, mean, rms, outward_max, inward_max, mean_along_normal, area_before,
               area_after, volume_before, volume_after)

/// Needs: as many vertices before as after; triangles that index them. Vertices without a triangle
/// do not count. Cost: linear; scratch of 57 bytes a vertex.
Deviation deviation_of(std::span<const Vec3d> before, std::span<const Vec3d> after,
                       std::span<const Triangle> triangles);

}  // namespace burnish

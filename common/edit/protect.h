#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// Cells inside a polygon in a picture.
struct LassoRegion {
  /// Row by row; takes (x, y, z, 1) in file units to clip space, z towards the back.
  std::array<double, 16> view_projection = {};
  std::vector<Eigen::Vector2d> polygon;  ///< the picture is -1 to 1, y upwards; even-odd
  bool through = false;                  ///< also surface that faces away
};

/// Cells whose principal curvature of the larger magnitude is within these ends. User units (κ·L).
struct CurvatureRegion {
  double least = 0, most = 0;
};

/// All cells that the surface leads to from the cell nearest to a point, file units.
struct PieceRegion {
  Vec3d point = Vec3d::Zero();
};

/// Cells at most so many steps from protected ones; below zero: away from unprotected ones.
struct GrownRegion {
  int cells = 1;
};

struct InvertedRegion {};  ///< cells that are not protected
struct NoRegion {};        ///< no cell

/// Changes the protected region: there nothing moves, and no edit counts.
struct Protect {
  std::variant<LassoRegion, CurvatureRegion, PieceRegion, GrownRegion, InvertedRegion, NoRegion>
      way;
  bool release = false;  ///< a lasso, a curvature or a piece takes its cells out
};

inline constexpr size_t kLassoPointsMax = 1024;
inline constexpr int kGrowCellsMax = 64;

/// Describes it in a few words: "protect lasso of 12 points", "release piece", "protect: grow by
/// 2".
std::string summary(const Protect& change);

/// Fails: invalid_argument that names the thing, its value and its limit.
Status validate(const Protect& change);

}  // namespace burnish

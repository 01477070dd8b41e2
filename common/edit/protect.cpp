#include "common/edit/protect.h"

#include <cmath>
#include <cstdio>

#include "common/base/limits.h"

namespace burnish {
namespace {

std::string as_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

struct Way {
  std::string operator()(const LassoRegion& lasso) const {
    return " lasso of " + std::to_string(lasso.polygon.size()) + " points" +
           (lasso.through ? ", through" : "");
  }
  std::string operator()(const CurvatureRegion& region) const {
    return " curvature " + as_number(region.least) + " to " + as_number(region.most);
  }
  std::string operator()(const PieceRegion&) const { return " piece"; }
  std::string operator()(const GrownRegion& region) const {
    return region.cells > 0 ? ": grow by " + std::to_string(region.cells)
                            : ": shrink by " + std::to_string(-region.cells);
  }
  std::string operator()(const InvertedRegion&) const { return ": invert"; }
  std::string operator()(const NoRegion&) const { return " nothing"; }
};

struct Check {
  Status operator()(const LassoRegion& lasso) const {
    const size_t points = lasso.polygon.size();
    if (points < 3 || points > kLassoPointsMax)
      return invalid_argument("a lasso of " + std::to_string(points) + " points is outside 3 to " +
                              std::to_string(kLassoPointsMax));
    for (const double x : lasso.view_projection)
      if (!std::isfinite(x))
        return invalid_argument("the lasso's view has the number " + as_number(x));
    for (const Eigen::Vector2d& p : lasso.polygon)
      if (!p.allFinite()) return invalid_argument("a point of the lasso is not finite");
    return Status::ok();
  }
  Status operator()(const CurvatureRegion& region) const {
    if (region.least <= region.most && region.least >= -kCurveKappaMagnitudeMax &&
        region.most <= kCurveKappaMagnitudeMax)
      return Status::ok();
    return invalid_argument("curvature " + as_number(region.least) + " to " +
                            as_number(region.most) + " is not a range within " +
                            as_number(kCurveKappaMagnitudeMax));
  }
  Status operator()(const PieceRegion& region) const {
    if ((region.point.array().abs() <= kCoordinateMagnitudeMax).all()) return Status::ok();
    return invalid_argument("the point of the piece is not within 1e18");
  }
  Status operator()(const GrownRegion& region) const {
    if (region.cells != 0 && std::abs(region.cells) <= kGrowCellsMax) return Status::ok();
    return invalid_argument("growing by " + std::to_string(region.cells) +
                            " cells is outside 1 to " + std::to_string(kGrowCellsMax) +
                            " both ways");
  }
  Status operator()(const InvertedRegion&) const { return Status::ok(); }
  Status operator()(const NoRegion&) const { return Status::ok(); }
};

}  // namespace

std::string summary(const Protect& change) {
  return (change.release ? "release" : "protect") + std::visit(Way{}, change.way);
}

Status validate(const Protect& change) {
  return std::visit(Check{}, change.way);
}

}  // namespace burnish

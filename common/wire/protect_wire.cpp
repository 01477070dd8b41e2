#include "common/wire/protect_wire.h"

#include <algorithm>

#include "common/wire/format_wire.h"

namespace burnish {
namespace {

struct WayWriter {
  v1::Protect& message;

  void operator()(const LassoRegion& lasso) const {
    v1::Lasso& sent = *message.mutable_lasso();
    for (const double x : lasso.view_projection) sent.add_view_projection(x);
    for (const Eigen::Vector2d& point : lasso.polygon) {
      sent.add_points(point.x());
      sent.add_points(point.y());
    }
    sent.set_through(lasso.through);
  }
  void operator()(const CurvatureRegion& region) const {
    message.mutable_curvature()->set_least(region.least);
    message.mutable_curvature()->set_most(region.most);
  }
  void operator()(const PieceRegion& region) const {
    *message.mutable_piece() = to_wire(region.point);
  }
  void operator()(const GrownRegion& region) const { message.set_grow(region.cells); }
  void operator()(const InvertedRegion&) const { message.mutable_invert(); }
  void operator()(const NoRegion&) const { message.mutable_clear(); }
};

Result<LassoRegion> lasso_from_wire(const v1::Lasso& message) {
  LassoRegion lasso;
  if (message.view_projection_size() != static_cast<int>(lasso.view_projection.size()))
    return invalid_argument("the lasso's view has " +
                            std::to_string(message.view_projection_size()) + " numbers, not 16");
  if (message.points_size() % 2 != 0)
    return invalid_argument("the lasso has " + std::to_string(message.points_size()) +
                            " coordinates, not two for each point");
  std::ranges::copy(message.view_projection(), lasso.view_projection.begin());
  for (int i = 0; i < message.points_size(); i += 2)
    lasso.polygon.emplace_back(message.points(i), message.points(i + 1));
  lasso.through = message.through();
  return lasso;
}

}  // namespace

v1::Protect to_wire(const Protect& change) {
  v1::Protect message;
  std::visit(WayWriter{message}, change.way);
  message.set_release(change.release);
  return message;
}

Result<Protect> from_wire(const v1::Protect& message) {
  Protect change{{}, message.release()};
  switch (message.way_case()) {
    case v1::Protect::kLasso: {
      ASSIGN_OR_RETURN(change.way, lasso_from_wire(message.lasso()));
      return change;
    }
    case v1::Protect::kCurvature:
      change.way = CurvatureRegion{message.curvature().least(), message.curvature().most()};
      return change;
    case v1::Protect::kPiece:
      change.way = PieceRegion{from_wire(message.piece())};
      return change;
    case v1::Protect::kGrow:
      change.way = GrownRegion{message.grow()};
      return change;
    case v1::Protect::kInvert:
      change.way = InvertedRegion{};
      return change;
    case v1::Protect::kClear:
      change.way = NoRegion{};
      return change;
    case v1::Protect::WAY_NOT_SET:
      break;
  }
  return invalid_argument("it protects in no way that this server knows");
}

}  // namespace burnish

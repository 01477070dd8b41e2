#include "client/model/view/section_view.h"

#include <algorithm>

namespace burnish {

Plane section_plane(const Ruler& ruler, const Camera& camera) {
  const Vec3d along = ruler.ends()[1].edited - ruler.ends()[0].edited;
  const Eigen::Matrix3d axes = camera_axes(camera);
  const Vec3d back = axes.row(2), up = axes.row(1);
  const Vec3d across = along.cross(back);
  // A ruler that runs along the view is cut upright.
  const Vec3d normal = across.norm() > 1e-9 * along.norm() ? across : Vec3d(along.cross(up));
  return {ruler.ends()[0].edited, normal.stableNormalized()};
}

SectionView::SectionView(const Plane& plane, const Ruler& ruler) {
  const PlaneAxes axes = axes_of(plane);
  const Vec3d way = ruler.ends()[1].edited - plane.point;
  const Eigen::Vector2d level(axes.right.dot(way), axes.up.dot(way));
  length_ = std::max(level.norm(), 1e-300);
  turn_ = level / length_;
}

Eigen::Vector2d SectionView::place(const Eigen::Vector2d& point) const {
  const double along = turn_.dot(point), height = turn_.x() * point.y() - turn_.y() * point.x();
  return Eigen::Vector2d(along, height) / length_;
}

std::vector<LengthTick> SectionView::ticks(double low, double high, double apart,
                                           const std::string& unit) const {
  auto ticks = length_ticks(low * length_, high * length_, apart * length_, unit);
  for (LengthTick& tick : ticks) tick.at /= length_;
  return ticks;
}

}  // namespace burnish

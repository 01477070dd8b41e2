#include "server/prepare/triangle_shape.h"

#include <algorithm>

namespace burnish {

// Twice the area over the longest edge squared. A flatter triangle counts as collinear.
static constexpr double kFlatness = 1e-12;
// Far below rounding for lengths of about 1; keeps the fourth powers of edges from underflow.
static constexpr double kLeastTwiceArea = 1e-60;

TriangleShape make_triangle_shape(const MeshView& mesh, const Triangle& triangle, double unit) {
  const double scale = 1 / unit;  // exact, as units are powers of two
  TriangleShape shape;
  for (int k = 0; k < 3; ++k) {
    const Vec3d& from = mesh.vertices[triangle[(k + 1) % 3]];
    const Vec3d& to = mesh.vertices[triangle[(k + 2) % 3]];
    shape.edges[k] = (to - from) * scale;
    shape.squared[k] = shape.edges[k].squaredNorm();
  }
  shape.cross = shape.edges[0].cross(shape.edges[1]);
  shape.twice_area = shape.cross.norm();
  const double longest = std::max({shape.squared[0], shape.squared[1], shape.squared[2]});
  shape.has_plane = shape.twice_area > std::max(kFlatness * longest, kLeastTwiceArea);
  return shape;
}

TangentFrame TriangleShape::frame() const {
  const auto longest = std::max_element(squared.begin(), squared.end()) - squared.begin();
  const Vec3d normal = cross / twice_area;
  const Vec3d u = edges[longest].normalized();
  return {u, normal.cross(u), normal};
}

double TriangleShape::voronoi_area(int k) const {
  const double area = twice_area / 2;
  std::array<double, 3> circumcentre;  // its barycentric weights, not normalised
  for (int i = 0; i < 3; ++i)
    circumcentre[i] = squared[i] * (squared[(i + 1) % 3] + squared[(i + 2) % 3] - squared[i]);
  const int obtuse = static_cast<int>(std::min_element(circumcentre.begin(), circumcentre.end()) -
                                      circumcentre.begin());
  if (circumcentre[obtuse] > 0) {
    const double sum = circumcentre[0] + circumcentre[1] + circumcentre[2];
    return area / 2 * (circumcentre[(k + 1) % 3] + circumcentre[(k + 2) % 3]) / sum;
  }
  // An acute corner keeps the right-angled piece cut off by the bisector of its short edge. The
  // obtuse corner keeps the rest.
  const auto acute_area = [&](int acute) {
    const int joining = 3 - acute - obtuse;
    return -area / 4 * squared[joining] / edges[obtuse].dot(edges[joining]);
  };
  if (k != obtuse) return acute_area(k);
  return area - acute_area((k + 1) % 3) - acute_area((k + 2) % 3);
}

}  // namespace burnish

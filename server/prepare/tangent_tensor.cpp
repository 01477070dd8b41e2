#include "server/prepare/tangent_tensor.h"

#include <cmath>

namespace burnish {

static constexpr double kOppositeNormals = 1e-12;  // 1 + cosine

TangentTensor carry_tensor(const TangentTensor& tensor, const TangentFrame& from,
                           const TangentFrame& to) {
  // The rotation that takes to.normal to from.normal moves a tangent x of `to` by -(x·m)(n + m)/(1
  // + n·m); n and m are the two normals.
  const double one_plus_cosine = 1 + from.normal.dot(to.normal);
  Vec3d u = to.u;
  Vec3d v = to.v;
  if (one_plus_cosine > kOppositeNormals) {
    const Vec3d towards = (from.normal + to.normal) / one_plus_cosine;
    u -= to.u.dot(from.normal) * towards;
    v -= to.v.dot(from.normal) * towards;
  }
  const double uu = u.dot(from.u), uv = u.dot(from.v);
  const double vu = v.dot(from.u), vv = v.dot(from.v);
  return {tensor.uu * uu * uu + 2 * tensor.uv * uu * uv + tensor.vv * uv * uv,
          tensor.uu * uu * vu + tensor.uv * (uu * vv + uv * vu) + tensor.vv * uv * vv,
          tensor.uu * vu * vu + 2 * tensor.uv * vu * vv + tensor.vv * vv * vv};
}

PrincipalAxes diagonalise(const TangentTensor& tensor, const TangentFrame& frame) {
  const double mean = (tensor.uu + tensor.vv) / 2;
  const double half_difference = (tensor.uu - tensor.vv) / 2;
  const double radius = std::hypot(half_difference, tensor.uv);
  const double angle = std::atan2(tensor.uv, half_difference) / 2;  // 0 at an umbilic
  const double c = std::cos(angle), s = std::sin(angle);
  return {mean + radius, mean - radius, c * frame.u + s * frame.v, c * frame.v - s * frame.u};
}

}  // namespace burnish

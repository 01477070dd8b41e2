#pragma once

#include <Eigen/Geometry>

#include "common/base/types.h"

namespace burnish {

/// Orthonormal: u and v span a tangent plane, normal = u × v.
struct TangentFrame {
  Vec3d u, v, normal;
};

/// Returns a frame with this normal, always the same one. Needs: a unit vector.
inline TangentFrame make_frame(const Vec3d& normal) {
  const Vec3d u = normal.unitOrthogonal();
  return {u, normal.cross(u), normal};
}

/// A symmetric tensor on a tangent plane, by its components in a frame of that plane.
struct TangentTensor {
  double uu = 0, uv = 0, vv = 0;

  void add(double weight, const TangentTensor& other) {
    uu += weight * other.uu;
    uv += weight * other.uv;
    vv += weight * other.vv;
  }
  TangentTensor scaled(double factor) const { return {factor * uu, factor * uv, factor * vv}; }
};

/// Returns the components in `to` of a tensor given in `from`, after the least rotation that
/// carries one plane onto the other. Opposite normals share a plane: then nothing is rotated.
/// Source: Rusinkiewicz 2004, section 3.
TangentTensor carry_tensor(const TangentTensor& tensor, const TangentFrame& from,
                           const TangentFrame& to);

/// Eigenvalues, larger first, and their unit directions in space.
struct PrincipalAxes {
  double kappa1, kappa2;
  Vec3d v1, v2;
};
PrincipalAxes diagonalise(const TangentTensor& tensor, const TangentFrame& frame);

}  // namespace burnish

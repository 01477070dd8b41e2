#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/pages/page.h"

namespace burnish {

/// Returns at each vertex the sum of its triangles' corner_normals(). The length is not one.
/// Shapes: one per position.
std::vector<Vec3f> sum_corner_normals(std::span<const Vec3f> positions,
                                      std::span<const PageTriangle> triangles);

/// Turns a normal by the rotation that takes one direction to another, around their common
/// perpendicular. Opposite directions have no such rotation; then the result is along `to`.
/// Keeps the normal if a direction is zero. Needs: a unit normal; directions of any length.
Vec3f turned_normal(const Vec3f& normal, const Vec3f& from, const Vec3f& to);

}  // namespace burnish

#pragma once

#include <span>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// Returns unit normals: the direction of the sum of the corner_normals() of the adjacent
/// triangles. A vertex without a triangle of positive area gets (0, 0, 1). Shapes: one per vertex.
std::vector<Vec3f> vertex_normals(std::span<const Vec3d> vertices,
                                  std::span<const Triangle> triangles);

}  // namespace burnish

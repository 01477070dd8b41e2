#pragma once

#include <span>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// Returns unit normals: the mean of the adjacent triangles' normals, weighted by their angle at
/// the vertex. A vertex without a triangle of positive area gets (0, 0, 1).
/// Shapes: one per vertex.
std::vector<Vec3f> vertex_normals(std::span<const Vec3d> vertices,
                                  std::span<const Triangle> triangles);

}  // namespace burnish

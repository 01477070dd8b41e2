#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Returns the numbers of all triangles in the Morton order of their middles in a grid of 1024^3
/// cells. Triangles of one cell keep the file's order. Needs: a box of all triangles that is not a
/// point. Cost: O(triangles).
std::vector<uint32_t> spatial_order(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box);

}  // namespace burnish

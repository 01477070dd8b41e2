#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The components of a mesh, connected through edges: for each vertex the least one of its
/// component. Cost: near linear time.
std::vector<int32_t> component_roots(std::span<const Triangle> triangles, size_t vertices);

}  // namespace burnish

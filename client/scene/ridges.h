#pragma once

#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/pages/page.h"

namespace burnish {

/// Returns how much the surface bends at each vertex: the divergence of normals along its edges,
/// averaged twice over neighbours against noise, and mapped to -1 (groove) to 1 (ridge).
/// Shapes: one per vertex. Units: a ridge of 0.5 has a curvature of 60 per unit of the positions.
std::vector<float> vertex_ridges(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                                 std::span<const Triangle> triangles);
std::vector<float> vertex_ridges(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                                 std::span<const PageTriangle> triangles);

}  // namespace burnish

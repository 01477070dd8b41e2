#pragma once

#include <span>

#include "common/mesh/rewrite/gltf/gltf_columns.h"

namespace burnish {

/// Private to this folder. Turns the normals of the columns that have some. `before` and `after`
/// are positions in the scene, by vertex of the surface.
void turn_normals(const GltfSurface& surface, std::span<const Vec3d> before,
                  std::span<const Vec3d> after, GltfColumns& columns);

}  // namespace burnish

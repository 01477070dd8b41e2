#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "common/base/types.h"
#include "common/mesh/gltf/gltf_surface.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"

namespace burnish {

/// The new positions or normals of an accessor under one node, in the node's frame.
struct GltfColumn {
  size_t points = 0;  ///< of the surface: whose positions, or normals
  GltfAccessor accessor;
  std::vector<Vec3f> values;  ///< one per element
  bool is_changed = false;
};

/// The columns of a moved surface. Those of a surface that stays have no changes.
struct GltfColumns {
  std::vector<GltfColumn> all;
  std::vector<size_t> positions;               ///< a column for each part of the surface
  std::vector<std::optional<size_t>> normals;  ///< likewise

  bool is_changed() const;
};

/// Computes the new positions, and the new normals where the file has some. A value that rounds to
/// the same float in its node's frame stays. So does the normal of a place without a move around
/// it. Elements at the same place with the same normal get one normal; others keep their crease.
GltfColumns move_columns(const GltfSurface& surface, const MovedMesh& moved);

}  // namespace burnish

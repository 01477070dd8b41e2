#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/rewrite/moved/colour_edit.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A mesh as read_mesh() gave it, and the same mesh with other positions and colours. Triangles and
/// the order of vertices are the file's. Needs: as many positions before as after.
struct MovedMesh {
  std::span<const Vec3d> before;
  MeshView after;
  double cap = 0;  ///< no vertex is written farther from its place than this; 0: anywhere
  std::span<const Rgba8> colours_before = {};  ///< as read_mesh() gave them
  std::span<const TexelChange> texels = {};    ///< as ColourEdit has them
  SeamWish seams = {};                         ///< likewise

  ColourEdit colours() const { return {colours_before, after.colours, texels, seams}; }
};

/// Fails: data_loss if the original does not have this coordinate: it is not the file that was
/// read. Numbers that are no coordinates pass: a vertex that no triangle uses may have them
/// (common/mesh/reading/odd_vertices.h).
Status check_unchanged(const MovedMesh& moved, const std::string& name, uint64_t vertex, int axis,
                       double value);

/// "NAME is not the file that was read: WHAT".
Status changed_original(const std::string& name, const std::string& what);

}  // namespace burnish

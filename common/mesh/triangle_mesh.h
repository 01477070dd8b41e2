#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// An indexed triangle mesh as scanners leave it: it may have boundary, non-manifold edges,
/// zero-area triangles, several components, and vertices that no triangle references.
struct TriangleMesh {
  std::vector<Vec3d> vertices;      ///< positions in the file's own units
  std::vector<Triangle> triangles;  ///< indices into `vertices`
  std::vector<Rgba8> colours;       ///< empty, or one per vertex: of the file, or of its textures

  /// True if the source has more than float precision (PLY double, long decimals), as survey
  /// coordinates have. Writers then write doubles, else floats.
  bool has_double_positions = false;

  bool has_colours() const { return !colours.empty(); }
};

/// A mesh whose arrays belong to somebody else.
struct MeshView {
  MeshView() = default;
  MeshView(const TriangleMesh& mesh)
      : vertices(mesh.vertices),
        triangles(mesh.triangles),
        colours(mesh.colours),
        has_double_positions(mesh.has_double_positions) {}

  std::span<const Vec3d> vertices;
  std::span<const Triangle> triangles;
  std::span<const Rgba8> colours;  ///< empty, or one per vertex
  bool has_double_positions = false;

  bool has_colours() const { return !colours.empty(); }
};

/// Checks what every consumer may assume of a mesh: at least one triangle, counts within the
/// limits, indices in range, coordinates finite and within kCoordinateMagnitudeMax, no colours or
/// one per vertex, and a positive, finite total area.
/// Fails: invalid_argument that names the first bad vertex or triangle, its value and the limit.
Status validate(const MeshView& mesh);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "common/base/status.h"
#include "common/gltf/primitive.h"
#include "common/gltf/scene.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The positions of an accessor as one node places them.
struct GltfPoints {
  size_t placement = 0;
  GltfAccessor positions;
  std::vector<uint32_t> vertices;  ///< of the mesh, one per position; kNoVertex: in no triangle
};

inline constexpr uint32_t kNoVertex = UINT32_MAX;

/// A primitive as one node places it.
struct GltfPart {
  size_t placement = 0;
  const GltfPrimitive* primitive = nullptr;
  size_t points = 0;          ///< index of its GltfPoints
  size_t first_triangle = 0;  ///< of the mesh
  size_t triangles = 0;
};

/// The surface of a glTF file's scene, and where in the file it comes from. Positions are those of
/// the scene; equal ones are one vertex.
struct GltfSurface {
  TriangleMesh mesh;
  std::vector<GltfPlacement> placements;
  std::map<std::pair<uint64_t, uint64_t>, std::optional<GltfPrimitive>> primitives;  ///< by mesh
  std::vector<GltfPoints> points;
  std::vector<GltfPart> parts;
};

/// Reads the scene's surface. `views` keep the bytes that the result refers to. Fails:
/// invalid_argument.
Result<GltfSurface> read_gltf_surface(UnpackedViews& views);

/// Calls `use(a, b, c)` for each triangle of a primitive with its corners' numbers among the
/// primitive's positions. A strip's joints are left out.
template <typename Use>
void for_each_triangle(const GltfPrimitive& primitive, const Use& use) {
  const uint64_t corners = primitive.corner_count();
  const auto at = [&](uint64_t i) { return static_cast<uint32_t>(primitive.corner(i)); };
  if (primitive.mode == GltfMode::kTriangles) {
    for (uint64_t i = 0; i + 2 < corners; i += 3) use(at(i), at(i + 1), at(i + 2));
    return;
  }
  const bool is_strip = primitive.mode == GltfMode::kTriangleStrip;
  for (uint64_t i = 2; i < corners; ++i) {
    const uint32_t a = is_strip ? at(i - 2) : at(0);
    const uint32_t b = at(i - 1), c = at(i);
    if (is_strip && (a == b || b == c || c == a)) continue;
    is_strip&& i % 2 == 1 ? use(b, a, c) : use(a, b, c);
  }
}

/// Reads a .glb or .gltf file as read_mesh() does. `buffers` gives the buffers that it names, and
/// `beside` its pictures.
Result<TriangleMesh> read_gltf(std::span<const uint8_t> bytes, const std::string& name,
                               const GltfFilesBeside& buffers, const MeshSurroundings& beside = {});

}  // namespace burnish

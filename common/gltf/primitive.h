#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/base/status.h"
#include "common/gltf/accessor.h"

namespace burnish {

/// How a primitive's corners make triangles, as glTF numbers it.
enum class GltfMode : uint32_t { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };

/// A part of a mesh that is a surface.
struct GltfPrimitive {
  uint64_t mesh = 0;
  uint64_t number = 0;  ///< within the mesh
  GltfMode mode = GltfMode::kTriangles;
  bool is_draco = false;
  std::map<std::string, GltfAccessor> attributes;  ///< POSITION, and NORMAL and COLOR_0 if there
                                                   ///< are some; of Draco all that it has
  std::optional<GltfAccessor> indices;

  const GltfAccessor& positions() const { return attributes.at("POSITION"); }
  const GltfAccessor* find(const std::string& name) const;
  uint64_t corner_count() const { return indices ? indices->count : positions().count; }

  /// Returns the vertex of a corner. Needs: in range.
  uint64_t corner(uint64_t i) const { return indices ? indices->whole(i) : i; }
};

/// Reads a primitive. Returns nothing for points and lines, and for one without positions. Fails:
/// invalid_argument for damaged accessors, an index beyond the positions, morph targets.
Result<std::optional<GltfPrimitive>> read_primitive(UnpackedViews& views, uint64_t mesh,
                                                    uint64_t number);

/// "mesh 2, primitive 0".
std::string primitive_text(uint64_t mesh, uint64_t number);

}  // namespace burnish

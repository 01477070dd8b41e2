#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/textures/surface_textures.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A scan's surface with the textures of its file.
struct TexturedSurface {
  /// Its colours, if it has any, multiply the textures in linear light. An OBJ or a PLY has them
  /// only without textures.
  TriangleMesh mesh;
  /// Without triangles if the file has none, or if they do not fit the mesh; it may have pictures.
  SurfaceTextures textures;
};

/// Gets a surface whose pictures can be read during the call.
using TakeSurface = std::function<Status(const TexturedSurface& surface)>;

/// Returns whether a stored file may have pictures, from its directory alone: false means that it
/// has none. A damaged file may have some.
bool may_have_pictures(std::span<const uint8_t> bytes, MeshFormat format);

/// Reads and validates the mesh of a stored file and its textures, without any picture's texels.
/// `name` is for messages. Fails: as read_mesh(); as `take` does.
Status read_textured_surface(std::span<const uint8_t> bytes, MeshFormat format,
                             const std::string& name, const TakeSurface& take,
                             const MeshSurroundings& beside = {});

}  // namespace burnish

#pragma once

#include "common/mesh/files/files_beside.h"
#include "common/mesh/gltf/gltf_surface.h"
#include "common/mesh/textures/surface_textures.h"

namespace burnish {

/// Reads the materials of a glTF surface: baseColorFactor, baseColorTexture with its sampler and
/// KHR_texture_transform, TEXCOORD_n. A picture is embedded, a data URI, or a file beside it.
/// Anything damaged or missing counts as none, so that no surface is refused for its looks. Returns
/// none without materials. Needs: `views` and the files outlive the result.
SurfaceTextures read_gltf_textures(UnpackedViews& views, const GltfSurface& surface,
                                   const MeshSurroundings& beside);

}  // namespace burnish

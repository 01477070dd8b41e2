#pragma once

#include <cstdint>
#include <span>

#include "common/base/types.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/textures/surface_textures.h"

namespace burnish {

/// Reads the texture coordinates of a PLY file that read_ply() has read to these triangles: of the
/// corners of faces (a list "texcoord"), else of vertices ("s" and "t", "u" and "v", "texture_u"
/// and "texture_v"). v counts from the bottom. A face's "texnumber" counts the comments
/// "TextureFile"; a face without it has the first. Returns none if none of these pictures is there,
/// and pictures alone if the file has no coordinates. Needs: files, which outlive the result.
SurfaceTextures read_ply_textures(std::span<const uint8_t> ply, std::span<const Triangle> triangles,
                                  const MeshSurroundings& beside);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/textures/surface_textures.h"

namespace burnish {

/// Reads `vt`, `usemtl` and `f` of an OBJ file that read_obj() has read, and its material files. A
/// picture (map_Kd) takes the place of Kd. References that lead nowhere count as none. Returns none
/// without materials. Fails: as a material file cannot be read. Needs: files, which outlive the
/// result.
Result<SurfaceTextures> read_obj_textures(std::span<const uint8_t> obj,
                                          const MeshSurroundings& beside);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/files_beside.h"

namespace burnish {

/// Returns a colour for each vertex of an OBJ file: its material's picture (map_Kd) at its first
/// texture coordinate, else the material's Kd, else white. Returns none if that is one colour for
/// all. Missing pictures, and kinds other than PNG and JPEG, count as none. Decodes one
/// picture at a time, row by row. `name` is for messages. Fails: as a material file or a picture
/// cannot be read, or its memory is refused; the message names it. Needs: files.
Result<std::vector<Rgba8>> obj_texture_colours(std::span<const uint8_t> obj, size_t vertices,
                                               const MeshSurroundings& beside,
                                               const std::string& name);

}  // namespace burnish

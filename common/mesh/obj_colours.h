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
/// all. Missing pictures, and kinds other than PNG and JPEG, count as none. Holds one picture at a
/// time. `path` is the OBJ's among `beside`; `name` is for messages. Fails: as a material file or a
/// picture cannot be read; the message names it.
Result<std::vector<Rgba8>> obj_texture_colours(std::span<const uint8_t> obj, size_t vertices,
                                               const std::string& path, const FilesBeside& beside,
                                               const std::string& name);

}  // namespace burnish

#pragma once

#include <string_view>

#include "common/mesh/mesh_io.h"

namespace burnish {

/// Returns the extension of a format's files: ".ply".
std::string_view extension_of(MeshFormat format);

}  // namespace burnish

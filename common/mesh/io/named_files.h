#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/mesh/files/files_beside.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

/// The files that a mesh file names, and those that they name.
struct NamedFiles {
  std::vector<std::string> found;    ///< paths, each once
  std::vector<std::string> missing;  ///< names, as the texts have them, each once
};

/// Finds the material files and pictures of an OBJ, the buffers and images of a glTF file, and the
/// pictures that the comments of a PLY name. An archive has its own, so only files that are missing
/// in it count, and its mesh is not unpacked beyond 256 MB. Other formats name none. Fails: as a
/// file cannot be read.
Result<NamedFiles> find_named_files(std::span<const uint8_t> bytes, MeshFormat format,
                                    const MeshSurroundings& beside);

}  // namespace burnish

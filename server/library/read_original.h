#pragma once

#include <filesystem>
#include <string>

#include "common/base/mapped_file.h"
#include "common/mesh/mesh_io.h"

namespace burnish {

/// Reads a stored file under the name that its user knows.
inline Result<TriangleMesh> read_original(const std::filesystem::path& path, MeshFormat format,
                                          const std::string& name) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  return read_mesh(file.bytes(), format, name);
}

}  // namespace burnish

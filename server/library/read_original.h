#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/base/mapped_file.h"
#include "common/mesh/mesh_io.h"

namespace burnish {

/// Reads a stored file into scratch space, under the name that its user knows.
inline Result<std::shared_ptr<const StoredMesh>> read_original(const std::filesystem::path& path,
                                                               MeshFormat format,
                                                               const std::string& name,
                                                               const ScratchSpace& space) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  ASSIGN_OR_RETURN(StoredMesh mesh, read_stored_mesh(file.bytes(), format, name, space));
  return std::make_shared<const StoredMesh>(std::move(mesh));
}

}  // namespace burnish

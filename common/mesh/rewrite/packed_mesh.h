#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/mesh/files/archive_files.h"

namespace burnish {

/// Private to this folder: an archive, its mesh, and the mesh file's bytes.
struct PackedMesh {
  Archive archive;
  ArchivedMesh mesh;
  std::vector<uint8_t> bytes;
  std::string name;  ///< of the mesh file, for messages

  /// Fails: as the archive cannot be read; as `budget` does.
  static Result<PackedMesh> open(std::span<const uint8_t> archive, const std::string& name,
                                 const FileBudget& budget = {});
};

}  // namespace burnish

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "common/archive/archive.h"
#include "common/base/status.h"
#include "common/mesh/files/archive_files.h"

namespace burnish {

/// The files that were written of an archive.
struct PlacedMesh {
  std::filesystem::path mesh;
  std::vector<std::string> left_out;  ///< hidden entries, and those outside the mesh's folder
};

/// Writes the mesh of an archive to `file`, and the entries of its folder and below beside it,
/// under their own names, so that the mesh still finds them. `file` itself is replaced.
/// Fails: as place_files().
Result<PlacedMesh> place_mesh(const Archive& archive, const ArchivedMesh& mesh,
                              const std::filesystem::path& file, bool replaces);

/// Writes all entries of an archive but hidden ones into a folder, and makes it. Fails: as
/// place_files().
Result<PlacedMesh> place_archive(const Archive& archive, const ArchivedMesh& mesh,
                                 const std::filesystem::path& folder, bool replaces);

/// Checks before long work that the files beside a mesh can go beside its rewritten `copy`.
/// `buffers` are those that will have new bytes, as the mesh names them: none may be there. Fails:
/// already_exists naming the file; as a file cannot be read.
Status check_places_of(const std::filesystem::path& mesh, const std::filesystem::path& copy,
                       std::span<const std::string> buffers);

/// Puts the files beside a mesh also beside its rewritten `copy`: those that the mesh names, or
/// those of the archive that the mesh was in. Does nothing if the copy has another format, or lies
/// in the same folder as the mesh. Fails: as place_files(); as a file cannot be read.
Status place_files_of(const std::filesystem::path& mesh, const std::filesystem::path& copy,
                      bool replaces);

}  // namespace burnish

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/archive/archive.h"
#include "common/mesh/files_beside.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

/// The files in an archive. Case does not count where only one name fits: an archive from Windows
/// may name a.PNG what its texts call a.png.
class ArchiveFiles final : public FilesBeside {
 public:
  /// Needs: `archive` outlives this.
  explicit ArchiveFiles(const Archive& archive) : archive_(archive) {}

  Result<std::vector<uint8_t>> read(const std::string& path) const override;

 private:
  std::optional<std::string> locate(const std::string& path) const override;

  const Archive& archive_;
};

/// The one mesh of an archive.
struct ArchivedMesh {
  size_t entry = 0;
  std::string path;  ///< its name in the archive
  MeshFormat format = MeshFormat::kObj;
};

/// Finds the mesh by the extensions of the entries. Fails: invalid_argument if there is none, or
/// more than one; the message names them.
Result<ArchivedMesh> find_mesh(const Archive& archive);

}  // namespace burnish

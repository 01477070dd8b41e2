#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/archive/archive.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

/// The files in an archive. Case does not count where only one name fits: an archive from Windows
/// may name a.PNG what its texts call a.png.
class ArchiveFiles final : public FilesBeside {
 public:
  /// Needs: `archive` outlives this. `budget` hears of the work.
  explicit ArchiveFiles(const Archive& archive, FileBudget budget = {})
      : archive_(archive), budget_(std::move(budget)) {}
  ArchiveFiles(const ArchiveFiles&) = delete;
  ArchiveFiles& operator=(const ArchiveFiles&) = delete;

  Result<std::vector<uint8_t>> read(const std::string& path) const override;

 private:
  std::optional<std::string> locate(const std::string& path) const override;

  const Archive& archive_;
  const FileBudget budget_;
  mutable FileSteps steps_{budget_};  // names times entries can be many
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

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/base/mapped_file.h"
#include "common/base/status.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

/// A scan on disk as one file to send: the mesh file as it is, or an archive of it and of the files
/// that it names, if some lie beside it. The same files give the same bytes.
class ScanBundle {
 public:
  /// Takes a mesh file, or a folder with one mesh file in it. Packs files in the mesh's folder and
  /// below only; none if `alone`. Fails: invalid_argument (no mesh or several in the folder,
  /// another extension); as the files cannot be read; resource_exhausted.
  static Result<ScanBundle> open(const std::filesystem::path& path, bool alone = false);

  /// The mesh file.
  const std::filesystem::path& mesh() const { return mesh_; }

  /// Returns the format of bytes().
  MeshFormat format() const { return format_; }
  std::span<const uint8_t> bytes() const {
    return file_ ? file_->bytes() : std::span<const uint8_t>(packed_);
  }

  /// Paths of the packed files beside the mesh, relative to its folder.
  const std::vector<std::string>& beside() const { return beside_; }
  /// The files that the mesh file names and that are not there, as it names them.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  ScanBundle() = default;
  Status gather();
  Status pack();

  std::filesystem::path mesh_;
  MeshFormat format_ = MeshFormat::kPly;
  std::optional<MappedFile> file_;  // unless packed
  std::vector<uint8_t> packed_;
  std::vector<std::string> beside_;
  std::vector<std::string> missing_;
};

/// Returns the mesh file that `path` means: itself, or the only one in the folder. Fails:
/// invalid_argument (none, several); as errno says.
Result<std::filesystem::path> mesh_file_of(const std::filesystem::path& path);

}  // namespace burnish

#include "common/mesh/io/zip_reader.h"

#include <algorithm>

#include "common/archive/archive_writer.h"
#include "common/base/limits.h"
#include "common/mesh/files/archive_files.h"
#include "common/mesh/io/mesh_io.h"

namespace burnish {

Result<TriangleMesh> read_zip(std::span<const uint8_t> bytes, const std::string& name,
                              const FileBudget& budget) {
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(bytes, name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  ASSIGN_OR_RETURN(const auto content, archive.read(mesh.entry, budget));
  const ArchiveFiles files(archive, budget);
  return read_mesh(content, mesh.format, name + ": " + mesh.path, {&files, mesh.path, budget});
}

/// The archive's files are unpacked one at a time: the mesh first, then the pictures. A
/// picture is decoded row by row; what its decoder takes is asked for when its header is known.
Result<uint64_t> predict_zip_reading_bytes(std::span<const uint8_t> bytes,
                                           const std::string& name) {
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(bytes, name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  uint64_t largest_picture = 0;
  uint64_t mesh_bytes = 0;  // a glTF file's positions may lie beside it
  for (const ArchiveEntry& entry : archive.entries()) {
    const bool is_picture = entry.name != mesh.path && is_compressed_by_name(entry.name);
    if (is_picture) largest_picture = std::max(largest_picture, entry.size_bytes);
    if (!is_picture) mesh_bytes += entry.size_bytes;
  }
  return mesh_bytes * kReadingBytesPerFileByte + largest_picture;
}

}  // namespace burnish

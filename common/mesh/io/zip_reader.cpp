#include "common/mesh/io/zip_reader.h"

#include <algorithm>

#include "common/archive/archive_writer.h"
#include "common/base/limits.h"
#include "common/gltf/document.h"
#include "common/gltf/reading_limit.h"
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

// Returns what the scene of a text glTF file may take: more than other meshes if it is packed. Its
// text is read before anybody is asked: a longer one has its data inside.
static Result<uint64_t> gltf_bytes(const Archive& archive, const ArchivedMesh& mesh,
                                   uint64_t mesh_bytes) {
  constexpr uint64_t kTextBytesMax = uint64_t{16} << 20;
  if (archive.entries()[mesh.entry].size_bytes > kTextBytesMax)
    return mesh_bytes * kReadingBytesPerFileByte;
  ASSIGN_OR_RETURN(const auto text, archive.read(mesh.entry));
  const auto json = read_gltf_json(text);  // a reader will say why it is damaged
  return mesh_bytes + (json.is_ok() ? gltf_reading_bytes_max(*json, mesh_bytes) : 0);
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
  uint64_t reading_bytes = mesh_bytes * kReadingBytesPerFileByte;
  if (mesh.format == MeshFormat::kGltf) {
    ASSIGN_OR_RETURN(reading_bytes, gltf_bytes(archive, mesh, mesh_bytes));
  }
  return reading_bytes + largest_picture;
}

}  // namespace burnish

#include <algorithm>

#include "common/archive/archive_writer.h"
#include "common/base/limits.h"
#include "common/mesh/archive_files.h"
#include "common/mesh/mesh_formats.h"

namespace burnish {

Result<TriangleMesh> read_zip(std::span<const uint8_t> bytes, const std::string& name) {
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(bytes, name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  ASSIGN_OR_RETURN(const auto content, archive.read(mesh.entry));
  const ArchiveFiles files(archive);
  return read_mesh(content, mesh.format, name + ": " + mesh.path, {&files, mesh.path});
}

/// The archive's files are unpacked one at a time: the mesh first, then the pictures.
Result<uint64_t> predict_zip_reading_bytes(std::span<const uint8_t> bytes,
                                           const std::string& name) {
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(bytes, name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  const bool is_gltf = mesh.format == MeshFormat::kGlb || mesh.format == MeshFormat::kGltf;
  const uint64_t times = is_gltf ? kGltfUnpackedBytesPerFileByte : kReadingBytesPerFileByte;
  uint64_t largest_picture = 0;
  for (const ArchiveEntry& entry : archive.entries())
    if (is_compressed_by_name(entry.name))
      largest_picture = std::max(largest_picture, entry.size_bytes);
  return archive.entries()[mesh.entry].size_bytes * times + largest_picture * kPictureMemoryPerByte;
}

}  // namespace burnish

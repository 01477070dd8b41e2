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

}  // namespace burnish

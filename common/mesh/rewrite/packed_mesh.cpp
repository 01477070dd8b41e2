#include "common/mesh/rewrite/packed_mesh.h"

#include <utility>

namespace burnish {

Result<PackedMesh> PackedMesh::open(std::span<const uint8_t> archive, const std::string& name,
                                    const FileBudget& budget) {
  ASSIGN_OR_RETURN(Archive opened, Archive::open(archive, name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(opened));
  ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, opened.read(mesh.entry, budget));
  return PackedMesh{std::move(opened), mesh, std::move(bytes), name + ": " + mesh.path};
}

}  // namespace burnish

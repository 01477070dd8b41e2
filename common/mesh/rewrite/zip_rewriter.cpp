#include <string_view>
#include <vector>

#include "common/archive/archive_writer.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/packed_mesh.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

static std::string_view as_view(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Writes the archive's mesh to memory. All entries besides it keep their bytes, so an archive
/// whose mesh keeps its bytes is copied as it is.
Status rewrite_zip(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  ASSIGN_OR_RETURN(const PackedMesh packed, PackedMesh::open(bytes, name));
  std::vector<uint8_t> after;
  OutputBuffer gathered([&](std::string_view piece) {
    after.insert(after.end(), piece.begin(), piece.end());
    return Status::ok();
  });
  RETURN_IF_ERROR(rewrite_mesh(packed.bytes, packed.mesh.format, packed.name, moved, gathered));
  if (after == packed.bytes) {
    output.put_text(as_view(bytes));
    return Status::ok();
  }
  auto replaced = replace_entry(bytes, packed.mesh.entry, after);
  if (!replaced.is_ok()) return replaced.status().with_context(name);
  output.put_text(as_view(*replaced));
  return Status::ok();
}

}  // namespace burnish

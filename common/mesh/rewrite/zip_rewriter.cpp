#include <string_view>
#include <vector>

#include "common/archive/archive_writer.h"
#include "common/mesh/archive_files.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

static std::string_view as_view(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Writes the archive's mesh to memory. All entries besides it keep their bytes, so an archive whose
/// mesh keeps its bytes is copied as it is.
Status rewrite_zip(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(bytes, name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  ASSIGN_OR_RETURN(const std::vector<uint8_t> before, archive.read(mesh.entry));
  std::vector<uint8_t> after;
  OutputBuffer gathered([&](std::string_view piece) {
    after.insert(after.end(), piece.begin(), piece.end());
    return Status::ok();
  });
  RETURN_IF_ERROR(rewrite_mesh(before, mesh.format, name + ": " + mesh.path, moved, gathered));
  if (after == before) {
    output.put_text(as_view(bytes));
    return Status::ok();
  }
  auto replaced = replace_entry(bytes, mesh.entry, after);
  if (!replaced.is_ok()) return replaced.status().with_context(name);
  output.put_text(as_view(*replaced));
  return Status::ok();
}

}  // namespace burnish

#include "common/mesh/files/archive_files.h"

#include "common/archive/entry_name.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

std::optional<std::string> ArchiveFiles::locate(const std::string& path) const {
  if (archive_.find(path) && !path.ends_with('/')) return path;
  std::optional<std::string> found;
  for (const ArchiveEntry& entry : archive_.entries()) {
    steps_.take();
    if (entry.is_folder() || !equals_ignoring_case(entry.name, path)) continue;
    if (found) return std::nullopt;
    found = entry.name;
  }
  return found;
}

Result<std::vector<uint8_t>> ArchiveFiles::read(const std::string& path) const {
  const auto entry = archive_.find(path);
  if (!entry) return not_found(archive_.name() + ": there is no entry " + shown_entry(path));
  return archive_.read(*entry, budget_);
}

/// macOS puts notes on each file into archives, under the file's own extension.
static bool is_note(const std::string& path) {
  const size_t last = path.rfind('/') + 1;
  return path.starts_with("__MACOSX/") || path.compare(last, 2, "._") == 0;
}

static bool is_mesh_name(const ArchiveEntry& entry) {
  if (entry.is_folder() || is_note(entry.name)) return false;
  const auto format = mesh_format_of_path(entry.name);
  return format.is_ok() && *format != MeshFormat::kZip;
}

Result<ArchivedMesh> find_mesh(const Archive& archive) {
  std::optional<ArchivedMesh> mesh;
  for (size_t e = 0; e < archive.entries().size(); ++e) {
    const ArchiveEntry& entry = archive.entries()[e];
    if (!is_mesh_name(entry)) continue;
    if (mesh)
      return invalid_argument(archive.name() + ": there are two meshes, " +
                              shown_entry(mesh->path) + " and " + shown_entry(entry.name) +
                              "; an archive must have 1");
    mesh = ArchivedMesh{e, entry.name, mesh_format_of_path(entry.name).value()};
  }
  if (mesh) return *mesh;
  return invalid_argument(
      archive.name() + ": none of its " + std::to_string(archive.entries().size()) +
      " entries is a mesh; it must have 1 " + extensions_text([](const MeshFormatFacts& known) {
        return known.format != MeshFormat::kZip;
      }));
}

}  // namespace burnish

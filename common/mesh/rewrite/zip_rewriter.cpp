#include <string_view>
#include <vector>

#include "common/archive/archive_writer.h"
#include "common/mesh/gltf/gltf_files.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/gltf/gltf_rewriter.h"
#include "common/mesh/rewrite/packed_mesh.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

namespace {

std::string_view as_view(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The entries of an archive that have new bytes.
class ChangedEntries {
 public:
  void add(size_t entry, std::vector<uint8_t> bytes) {
    contents_.push_back(std::move(bytes));
    entries_.push_back({entry, contents_.back()});  // its buffer stays where it is
  }
  std::span<const ChangedEntry> entries() const { return entries_; }

 private:
  std::vector<std::vector<uint8_t>> contents_;
  std::vector<ChangedEntry> entries_;
};

/// A glTF file may have its positions in a file beside it, which then changes too.
Status rewrite_packed_gltf(const PackedMesh& packed, const ArchiveFiles& beside,
                           const MovedMesh& moved, std::span<const EditedPicture> pictures,
                           OutputBuffer& output, ChangedEntries& changed) {
  GltfFiles files({&beside, packed.mesh.path, {}});
  std::vector<GltfFileBeside> buffers;
  RETURN_IF_ERROR(
      rewrite_gltf(packed.bytes, packed.name, files.reader(), moved, pictures, output, buffers));
  for (GltfFileBeside& buffer : buffers)
    if (const auto entry = packed.archive.find(files.path_of(buffer.path)))
      changed.add(*entry, std::move(buffer.bytes));
  return output.flush();
}

Status rewrite_packed(const PackedMesh& packed, const MovedMesh& moved, OutputBuffer& output,
                      ChangedEntries& changed, PictureWork* pictures) {
  const ArchiveFiles beside(packed.archive, output.budget());
  ASSIGN_OR_RETURN(
      auto edited,
      edit_pictures_of(
          {packed.bytes, packed.mesh.format, packed.name, {&beside, packed.mesh.path, {}}},
          moved.colours(), pictures));
  RETURN_IF_ERROR(is_gltf(packed.mesh.format)
                      ? rewrite_packed_gltf(packed, beside, moved, edited, output, changed)
                      : rewrite_mesh(packed.bytes, packed.mesh.format, packed.name, moved, output));
  for (EditedPicture& picture : edited)
    if (const auto entry = packed.archive.find(picture.path))
      changed.add(*entry, std::move(picture.bytes));
  return Status::ok();
}

}  // namespace

/// Writes the archive's mesh to memory, and pictures that change. All other entries keep their
/// bytes, so an archive whose mesh keeps its bytes is copied as it is.
Status rewrite_zip(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output, PictureWork* pictures) {
  ASSIGN_OR_RETURN(const PackedMesh packed, PackedMesh::open(bytes, name, output.budget()));
  std::vector<uint8_t> after;
  OutputBuffer gathered(
      [&](std::string_view piece) {
        after.insert(after.end(), piece.begin(), piece.end());
        return Status::ok();
      },
      output.budget());
  ChangedEntries changed;
  RETURN_IF_ERROR(rewrite_packed(packed, moved, gathered, changed, pictures));
  if (after != packed.bytes) changed.add(packed.mesh.entry, std::move(after));
  if (changed.entries().empty()) {
    output.put_text(as_view(bytes));
    return Status::ok();
  }
  auto replaced = replace_entries(bytes, changed.entries(), output.budget());
  if (!replaced.is_ok()) return replaced.status().with_context(name);
  output.put_text(as_view(*replaced));
  return Status::ok();
}

}  // namespace burnish

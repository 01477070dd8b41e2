#include "common/mesh/io/named_files.h"

#include <algorithm>
#include <utility>

#include "common/archive/archive.h"
#include "common/mesh/files/archive_files.h"
#include "common/mesh/gltf/gltf_files.h"
#include "common/mesh/obj/obj_files.h"
#include "common/mesh/ply/ply_textures.h"

namespace burnish {

static void add_name(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

static NamedFiles find_files(const std::vector<std::string>& names,
                             const MeshSurroundings& beside) {
  NamedFiles files;
  for (const std::string& name : names) {
    const auto path = beside.files->find(folder_of(beside.path), name);
    add_name(path ? files.found : files.missing, path.value_or(name));
  }
  return files;
}

static Result<NamedFiles> find_in_archive(std::span<const uint8_t> bytes) {
  constexpr uint64_t kUnpackedBytesMax = uint64_t{1} << 28;
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(bytes, "archive"));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  if (archive.entries()[mesh.entry].size_bytes > kUnpackedBytesMax) return NamedFiles();
  ASSIGN_OR_RETURN(const std::vector<uint8_t> unpacked, archive.read(mesh.entry));
  const ArchiveFiles files(archive);
  ASSIGN_OR_RETURN(NamedFiles named, find_named_files(unpacked, mesh.format, {&files, mesh.path}));
  named.found.clear();
  return named;
}

Result<NamedFiles> find_named_files(std::span<const uint8_t> bytes, MeshFormat format,
                                    const MeshSurroundings& beside) {
  if (format == MeshFormat::kZip) {
    auto named = find_in_archive(bytes);
    return named.is_ok() ? std::move(named) : NamedFiles();  // whoever reads it says why
  }
  if (format == MeshFormat::kPly) return find_files(textures_in_ply(bytes), beside);
  if (is_gltf(format)) {
    ASSIGN_OR_RETURN(GltfNames names, names_in_gltf(bytes));
    names.buffers.insert(names.buffers.end(), names.images.begin(), names.images.end());
    return find_files(names.buffers, beside);
  }
  if (format != MeshFormat::kObj) return NamedFiles();
  ASSIGN_OR_RETURN(ObjFiles files, find_obj_files(bytes, beside));
  return NamedFiles{std::move(files.found), std::move(files.missing)};
}

}  // namespace burnish

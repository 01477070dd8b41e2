#include "common/mesh/io/named_files.h"

#include <algorithm>
#include <utility>

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

Result<NamedFiles> find_named_files(std::span<const uint8_t> bytes, MeshFormat format,
                                    const MeshSurroundings& beside) {
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

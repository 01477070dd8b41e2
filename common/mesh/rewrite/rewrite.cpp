#include "common/mesh/rewrite/rewrite.h"

#include "common/base/atomic_file.h"
#include "common/base/check.h"
#include "common/base/mapped_file.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/gltf_rewriter.h"
#include "common/mesh/rewrite/packed_mesh.h"

namespace burnish {

/// Rewrites a glTF file that has no files beside it.
static Status rewrite_alone(std::span<const uint8_t> original, const std::string& name,
                            const MovedMesh& moved, OutputBuffer& output) {
  std::vector<GltfFileBeside> none;
  return rewrite_gltf(original, name, nullptr, moved, output, none);
}

static Status rewrite_in_format(std::span<const uint8_t> original, MeshFormat format,
                                const std::string& name, const MovedMesh& moved,
                                OutputBuffer& output) {
  switch (format) {
    case MeshFormat::kPly:
      return rewrite_ply(original, name, moved, output);
    case MeshFormat::kObj:
      return rewrite_obj(original, name, moved, output);
    case MeshFormat::kStl:
      return rewrite_stl(original, name, moved, output);
    case MeshFormat::kOff:
      return rewrite_off(original, name, moved, output);
    case MeshFormat::kGlb:
    case MeshFormat::kGltf:
      return rewrite_alone(original, name, moved, output);
    case MeshFormat::kZip:
      return rewrite_zip(original, name, moved, output);
  }
  return invalid_argument(name + ": unknown mesh format");
}

Status rewrite_mesh(std::span<const uint8_t> original, MeshFormat format, const std::string& name,
                    const MovedMesh& moved, OutputBuffer& output) {
  BURNISH_CHECK(moved.before.size() == moved.after.vertices.size(),
                "a moved mesh has as many vertices as before");
  RETURN_IF_ERROR(rewrite_in_format(original, format, name, moved, output));
  return output.flush();
}

static Status write_rewritten(std::span<const uint8_t> original, MeshFormat format,
                              const std::string& name, const MovedMesh& moved,
                              const std::filesystem::path& path) {
  RETURN_IF_ERROR(validate(moved.after).with_context("cannot write " + path.string()));
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  OutputBuffer output(file);
  RETURN_IF_ERROR(rewrite_mesh(original, format, name, moved, output));
  return file.commit();
}

Status write_moved_mesh(const OriginalFile& original, const MovedMesh& moved,
                        const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const MeshFormat format, mesh_format_of_path(path));
  if (format != original.format && original.format != MeshFormat::kZip)
    return write_mesh(moved.after, path);
  ASSIGN_OR_RETURN(const MappedFile bytes, MappedFile::open(original.path));
  if (format == original.format)
    return write_rewritten(bytes.bytes(), format, original.name, moved, path);
  ASSIGN_OR_RETURN(const PackedMesh packed, PackedMesh::open(bytes.bytes(), original.name));
  if (format != packed.mesh.format) return write_mesh(moved.after, path);
  return write_rewritten(packed.bytes, format, packed.name, moved, path);
}

}  // namespace burnish

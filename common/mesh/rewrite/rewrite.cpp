#include "common/mesh/rewrite/rewrite.h"

#include <vector>

#include "common/archive/archive_writer.h"
#include "common/archive/entry_name.h"
#include "common/base/atomic_file.h"
#include "common/base/check.h"
#include "common/base/mapped_file.h"
#include "common/mesh/heard_validate.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/gltf/gltf_rewriter.h"
#include "common/mesh/rewrite/packed_mesh.h"
#include "common/mesh/rewrite/patch/written_mesh.h"
#include "common/mesh/rewrite/write_plan.h"

namespace burnish {

/// Rewrites a glTF file that has no files beside it.
static Status rewrite_alone(std::span<const uint8_t> original, MeshFormat format,
                            const std::string& name, const MovedMesh& moved, OutputBuffer& output,
                            PictureWork* pictures) {
  ASSIGN_OR_RETURN(const auto edited,
                   edit_pictures_of({original, format, name, {}}, moved.colours(), pictures));
  std::vector<GltfFileBeside> none;
  return rewrite_gltf(original, name, nullptr, moved, edited, output, none);
}

static Status rewrite_in_format(std::span<const uint8_t> original, MeshFormat format,
                                const std::string& name, const MovedMesh& moved,
                                OutputBuffer& output, PictureWork* pictures) {
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
      return rewrite_alone(original, format, name, moved, output, pictures);
    case MeshFormat::kZip:
      return rewrite_zip(original, name, moved, output, pictures);
  }
  return invalid_argument(name + ": unknown mesh format");
}

Status rewrite_mesh(std::span<const uint8_t> original, MeshFormat format, const std::string& name,
                    const MovedMesh& moved, OutputBuffer& output, PictureWork* pictures) {
  BURNISH_CHECK(moved.before.size() == moved.after.vertices.size(),
                "a moved mesh has as many vertices as before");
  RETURN_IF_ERROR(rewrite_in_format(original, format, name, moved, output, pictures));
  return output.flush();
}

static Status write_rewritten(std::span<const uint8_t> original, MeshFormat format,
                              const std::string& name, const MovedMesh& moved,
                              const std::filesystem::path& path, PictureWork* pictures,
                              const FileBudget& budget) {
  RETURN_IF_ERROR(
      validate(moved.after, FileSteps(budget)).with_context("cannot write " + path.string()));
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  OutputBuffer output(file, budget);
  RETURN_IF_ERROR(rewrite_mesh(original, format, name, moved, output, pictures));
  return file.commit();
}

/// Packs a file as it is, alone.
static Result<std::vector<uint8_t>> pack_alone(std::span<const uint8_t> file,
                                               const OriginalFile& original,
                                               const FileBudget& budget) {
  const std::string extension = extension_of(original.format);
  FileToPack packed = {original.name + extension, file};
  const bool is_name = packed.name.find('/') == std::string::npos && packed.name[0] != '.';
  if (!is_name || !check_entry_name(packed.name).is_ok()) packed.name = "scan" + extension;
  return pack_archive({&packed, 1}, budget);
}

/// Returns how a text has the doubles of a mesh: in the digits that its coordinates had.
static WrittenNumber doubles_in_text(const MovedMesh& moved) {
  TextDigits digits;
  for (const Vec3d& position : moved.before)
    for (const double coordinate : position) digits.add(number_text(coordinate));
  return WrittenNumber::of_text(moved, digits);
}

/// Writers round to floats, or keep doubles. A text has no more digits than it had.
static Status write_anew(const MovedMesh& moved, MeshFormat format,
                         const std::filesystem::path& path, const FileBudget& budget) {
  if (moved.after.has_double_positions && format == MeshFormat::kObj)
    return write_mesh(WrittenMesh(moved, doubles_in_text(moved)).moved().after, path, budget);
  if (!(moved.cap > 0) || moved.after.has_double_positions)
    return write_mesh(moved.after, path, budget);
  const WrittenNumber as_float = {
      .type = PlyType::kFloat32, .is_text = format == MeshFormat::kObj, .digits = {}};
  return write_mesh(WrittenMesh(moved, as_float).moved().after, path, budget);
}

Status write_moved_mesh(const OriginalFile& original, const MovedMesh& moved,
                        const std::filesystem::path& path, PictureWork* pictures,
                        const FileBudget& budget) try {
  ASSIGN_OR_RETURN(const MeshFormat format, mesh_format_of_path(path));
  ASSIGN_OR_RETURN(const WritePlan plan, plan_to_write(original, format));
  RETURN_IF_ERROR(check_one_file(plan));
  if (plan.way == WriteWay::kConvert) return write_anew(moved, format, path, budget);
  ASSIGN_OR_RETURN(const MappedFile bytes, MappedFile::open(original.path));
  if (plan.way == WriteWay::kRewrite)
    return write_rewritten(bytes.bytes(), format, original.name, moved, path, pictures, budget);
  if (plan.way == WriteWay::kPack) {
    ASSIGN_OR_RETURN(const auto archive, pack_alone(bytes.bytes(), original, budget));
    return write_rewritten(archive, format, original.name, moved, path, pictures, budget);
  }
  ASSIGN_OR_RETURN(const PackedMesh packed, PackedMesh::open(bytes.bytes(), original.name, budget));
  return write_rewritten(packed.bytes, format, packed.name, moved, path, pictures, budget);
} catch (const WorkCancelled&) {
  return cancelled("writing was cancelled");
}

}  // namespace burnish

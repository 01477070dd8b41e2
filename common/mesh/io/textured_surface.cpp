#include "common/mesh/io/textured_surface.h"

#include <algorithm>
#include <new>
#include <utility>

#include "common/archive/archive.h"
#include "common/gltf/document.h"
#include "common/mesh/files/archive_files.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/gltf/gltf_files.h"
#include "common/mesh/gltf/gltf_surface.h"
#include "common/mesh/gltf/gltf_textures.h"
#include "common/mesh/heard_validate.h"
#include "common/mesh/obj/obj.h"
#include "common/mesh/obj/obj_textures.h"
#include "common/mesh/ply/ply.h"
#include "common/mesh/ply/ply_texture_reader.h"

namespace burnish {

namespace {

/// A mesh file's bytes and what lies beside them.
struct SurfaceFile {
  std::span<const uint8_t> bytes;
  MeshFormat format;
  std::string name;
  MeshSurroundings beside;
};

bool fits(const TexturedSurface& surface) {
  return surface.textures.triangles.size() == surface.mesh.triangles.size();
}

Status hand_over(TexturedSurface surface, const SurfaceFile& file, const TakeSurface& take) {
  RETURN_IF_ERROR(validate(surface.mesh, FileSteps(file.beside.budget)).with_context(file.name));
  if (!fits(surface)) surface.textures.triangles = {};
  return take(surface);
}

// The textures take the place of the colours that a scan without them shows.
Status hand_over_in_place_of_colours(TexturedSurface surface, const SurfaceFile& file,
                                     const TakeSurface& take) {
  if (fits(surface)) surface.mesh.colours = {};
  return hand_over(std::move(surface), file, take);
}

Status take_obj(const SurfaceFile& file, const TakeSurface& take) {
  TexturedSurface surface;
  ASSIGN_OR_RETURN(surface.mesh, read_obj(file.bytes, file.name, FileSteps(file.beside.budget)));
  if (file.beside.files != nullptr) {
    ASSIGN_OR_RETURN(surface.textures, read_obj_textures(file.bytes, file.beside));
  }
  return hand_over_in_place_of_colours(std::move(surface), file, take);
}

Status take_ply(const SurfaceFile& file, const TakeSurface& take) {
  TexturedSurface surface;
  ASSIGN_OR_RETURN(surface.mesh, read_ply(file.bytes, file.name, FileSteps(file.beside.budget)));
  if (file.beside.files != nullptr)
    surface.textures = read_ply_textures(file.bytes, surface.mesh.triangles, file.beside);
  return hand_over_in_place_of_colours(std::move(surface), file, take);
}

Status take_gltf(const SurfaceFile& file, const TakeSurface& take) {
  GltfFiles files(file.beside);
  const FileSteps steps(file.beside.budget);
  auto document = open_gltf(file.bytes, files.reader(), steps);
  if (!document.is_ok()) return document.status().with_context(file.name);
  UnpackedViews views(*document, steps);
  auto read = read_gltf_surface(views);
  if (!read.is_ok()) return read.status().with_context(file.name);
  TexturedSurface surface;
  surface.textures = read_gltf_textures(views, *read, file.beside);
  surface.mesh = std::move(read->mesh);
  return hand_over(std::move(surface), file, take);
}

Status take_surface(const SurfaceFile& file, const TakeSurface& take);

Status take_zip(const SurfaceFile& file, const TakeSurface& take) {
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(file.bytes, file.name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  const FileBudget& budget = file.beside.budget;
  ASSIGN_OR_RETURN(const auto content, archive.read(mesh.entry, budget));
  const ArchiveFiles files(archive, budget);
  return take_surface(
      {content, mesh.format, file.name + ": " + mesh.path, {&files, mesh.path, budget}}, take);
}

Status take_surface(const SurfaceFile& file, const TakeSurface& take) {
  switch (file.format) {
    case MeshFormat::kPly:
      return take_ply(file, take);
    case MeshFormat::kObj:
      return take_obj(file, take);
    case MeshFormat::kGlb:
    case MeshFormat::kGltf:
      return take_gltf(file, take);
    case MeshFormat::kZip:
      return take_zip(file, take);
    case MeshFormat::kStl:
    case MeshFormat::kOff:
      break;
  }
  return invalid_argument(file.name + ": its format has no textures");
}

bool has_images(std::span<const uint8_t> bytes) {
  const auto json = read_gltf_json(bytes);
  if (!json.is_ok()) return true;  // reading it says why
  const GltfJson* images = find_member(*json, "images");
  return images != nullptr && images->is_array() && !images->empty();
}

bool has_pictures_inside(std::span<const uint8_t> bytes) {
  const auto archive = Archive::open(bytes, "");
  if (!archive.is_ok()) return true;  // reading it says why
  const auto mesh = find_mesh(*archive);
  if (!mesh.is_ok()) return true;
  if (is_gltf(mesh->format)) return true;  // they may lie in its buffers
  return std::ranges::any_of(archive->entries(), [&](const ArchiveEntry& entry) {
    return !entry.is_folder() && entry.name != mesh->path && !entry.name.ends_with(".mtl");
  });
}

}  // namespace

bool may_have_pictures(std::span<const uint8_t> bytes, MeshFormat format) try {
  if (format == MeshFormat::kZip) return has_pictures_inside(bytes);
  return is_gltf(format) && has_images(bytes);
} catch (const std::bad_alloc&) {
  return true;
}

Status read_textured_surface(std::span<const uint8_t> bytes, MeshFormat format,
                             const std::string& name, const TakeSurface& take,
                             const MeshSurroundings& beside) try {
  return take_surface({bytes, format, name, beside}, take);
} catch (const WorkCancelled&) {
  return cancelled(name + ": reading was cancelled");
} catch (const std::bad_alloc&) {
  return resource_exhausted(name + ": not enough memory for a file of " +
                            std::to_string(bytes.size()) + " bytes");
}

}  // namespace burnish

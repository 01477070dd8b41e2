#include "common/mesh/io/mesh_io.h"

#include <new>

#include "common/base/atomic_file.h"
#include "common/base/limits.h"
#include "common/base/mapped_file.h"
#include "common/gltf/document.h"
#include "common/gltf/reading_limit.h"
#include "common/mesh/files/folder_files.h"
#include "common/mesh/gltf/glb_writer.h"
#include "common/mesh/gltf/gltf_files.h"
#include "common/mesh/gltf/gltf_surface.h"
#include "common/mesh/heard_validate.h"
#include "common/mesh/io/zip_reader.h"
#include "common/mesh/obj/obj.h"
#include "common/mesh/obj/obj_textures.h"
#include "common/mesh/off/off.h"
#include "common/mesh/ply/ply.h"
#include "common/mesh/ply/ply_texture_reader.h"
#include "common/mesh/stl/stl.h"
#include "common/mesh/textures/texture_colours.h"

namespace burnish {

/// Returns nullptr for formats that need an original.
static Status (*writer_of(MeshFormat format))(const MeshView& mesh, OutputBuffer& output) {
  if (format == MeshFormat::kPly) return write_ply;
  if (format == MeshFormat::kObj) return write_obj;
  if (format == MeshFormat::kStl) return write_stl;
  if (format == MeshFormat::kGlb) return write_glb;
  return nullptr;
}

static Result<TriangleMesh> read_textured_obj(std::span<const uint8_t> bytes,
                                              const std::string& name,
                                              const MeshSurroundings& beside) {
  ASSIGN_OR_RETURN(TriangleMesh mesh, read_obj(bytes, name, FileSteps(beside.budget)));
  if (mesh.has_colours() || beside.files == nullptr) return mesh;
  const auto textures = read_obj_textures(bytes, beside);
  if (!textures.is_ok()) return textures.status().with_context(name);
  RETURN_IF_ERROR(add_texture_colours(mesh, *textures, beside.budget, name));
  return mesh;
}

static Result<TriangleMesh> read_textured_ply(std::span<const uint8_t> bytes,
                                              const std::string& name,
                                              const MeshSurroundings& beside) {
  ASSIGN_OR_RETURN(TriangleMesh mesh, read_ply(bytes, name, FileSteps(beside.budget)));
  if (mesh.has_colours() || beside.files == nullptr) return mesh;
  const SurfaceTextures textures = read_ply_textures(bytes, mesh.triangles, beside);
  RETURN_IF_ERROR(add_texture_colours(mesh, textures, beside.budget, name));
  return mesh;
}

// A reader takes a whole file's bytes and its name for messages; validate() comes after it.
// Polygons become fans around their first corner; faces that repeat a vertex are kept; faces of
// fewer than three corners give no triangle. A vertex that no triangle uses may have coordinates
// that are none (OddVertices). Before memory is taken, every count is checked against the bytes
// that are left, and the triangles of polygons against the file's size. So memory stays below
// kReadingBytesPerFileByte times the file. Messages number elements and bytes from 0 and lines from
// 1. `steps` hears of every element.
static Result<TriangleMesh> parse_mesh(std::span<const uint8_t> bytes, MeshFormat format,
                                       const std::string& name, const MeshSurroundings& beside) {
  switch (format) {
    case MeshFormat::kPly:
      return read_textured_ply(bytes, name, beside);
    case MeshFormat::kObj:
      return read_textured_obj(bytes, name, beside);
    case MeshFormat::kStl:
      return read_stl(bytes, name, FileSteps(beside.budget));
    case MeshFormat::kOff:
      return read_off(bytes, name, FileSteps(beside.budget));
    case MeshFormat::kGlb:
    case MeshFormat::kGltf:
      return read_gltf(bytes, name, GltfFiles(beside).reader(), beside);
    case MeshFormat::kZip:
      return read_zip(bytes, name, beside.budget);
  }
  return invalid_argument(name + ": unknown mesh format");
}

// Runs a reader of a file's bytes.
template <typename Read>
static auto read_checked(std::span<const uint8_t> bytes, const std::string& name, const Read& read)
    -> decltype(read()) {
  if (bytes.empty()) return invalid_argument(name + ": the file is empty (0 bytes)");
  try {
    return read();
  } catch (const WorkCancelled&) {
    return cancelled(name + ": reading was cancelled");
  } catch (const ScratchFull& full) {
    return resource_exhausted(name + ": " + full.what());
  } catch (const std::bad_alloc&) {
    return resource_exhausted(name + ": not enough memory for a file of " +
                              std::to_string(bytes.size()) + " bytes");
  }
}

Result<TriangleMesh> read_mesh(std::span<const uint8_t> bytes, MeshFormat format,
                               const std::string& name, const MeshSurroundings& beside) {
  return read_checked(bytes, name, [&]() -> Result<TriangleMesh> {
    ASSIGN_OR_RETURN(TriangleMesh mesh, parse_mesh(bytes, format, name, beside));
    RETURN_IF_ERROR(validate(mesh, FileSteps(beside.budget)).with_context(name));
    return mesh;
  });
}

using ReadIntoScratch = Status (*)(std::span<const uint8_t>, const std::string&, const FileSteps&,
                                   GrowingMesh&);

static ReadIntoScratch scratch_reader_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::kPly:
      return read_ply;
    case MeshFormat::kObj:
      return read_obj;
    case MeshFormat::kStl:
      return read_stl;
    case MeshFormat::kOff:
      return read_off;
    case MeshFormat::kGlb:
    case MeshFormat::kGltf:
    case MeshFormat::kZip:
      return nullptr;
  }
  return nullptr;
}

Result<uint64_t> reading_bytes_max(const std::filesystem::path& path, MeshFormat format) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  const uint64_t bytes = file.bytes().size();
  if (format == MeshFormat::kZip) return predict_zip_reading_bytes(file.bytes(), path.string());
  if (!is_gltf(format)) return bytes * kReadingBytesPerFileByte;
  const auto json = read_gltf_json(file.bytes());  // a reader will say why it is damaged
  return json.is_ok() ? gltf_reading_bytes_max(*json, bytes) : kGltfUnpackedBytesMin;
}

bool is_read_into_scratch(MeshFormat format) {
  return scratch_reader_of(format) != nullptr;
}

Result<StoredMesh> read_stored_mesh(std::span<const uint8_t> bytes, MeshFormat format,
                                    const std::string& name, const ScratchSpace& space,
                                    const FileBudget& budget) {
  return read_checked(bytes, name, [&]() -> Result<StoredMesh> {
    const ReadIntoScratch read = scratch_reader_of(format);
    if (read == nullptr) {
      ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(bytes, format, name, {.budget = budget}));
      return StoredMesh(mesh, space);
    }
    GrowingMesh growing(space);
    RETURN_IF_ERROR(read(bytes, name, FileSteps(budget), growing));
    StoredMesh mesh = growing.take();
    RETURN_IF_ERROR(validate(mesh.view(), FileSteps(budget)).with_context(name));
    return mesh;
  });
}

Result<TriangleMesh> read_mesh(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const MeshFormat format, mesh_format_of_path(path));
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  const FolderFiles files(path.parent_path());
  return read_mesh(file.bytes(), format, path.string(), {&files, path.filename().string()});
}

Status write_mesh(const MeshView& mesh, const std::filesystem::path& path,
                  const FileBudget& budget) try {
  ASSIGN_OR_RETURN(const MeshFormat format, written_format_of_path(path));
  if (!is_written_for_any_scan(format))
    return invalid_argument("cannot write " + path.string() + ": only a scan from a " +
                            path.extension().string() + " file is written as one; use " +
                            extensions_text([](const MeshFormatFacts& known) {
                              return known.is_written_for_any_scan;
                            }));
  RETURN_IF_ERROR(validate(mesh, FileSteps(budget)).with_context("cannot write " + path.string()));
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  OutputBuffer output(file, budget);
  RETURN_IF_ERROR(writer_of(format)(mesh, output));
  return file.commit();
} catch (const WorkCancelled&) {
  return cancelled("writing was cancelled");
}

}  // namespace burnish

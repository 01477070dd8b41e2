#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/stored_mesh.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Reads and validates a mesh, and its textures. Messages name the file, the place in
/// it, the value and the limit. Fails: not_found, permission_denied, invalid_argument (damaged,
/// truncated, hostile, empty), resource_exhausted.
Result<TriangleMesh> read_mesh(const std::filesystem::path& path);

/// Reads a mesh from memory, for uploads and fuzzers. `name` is only used in messages. Colours come
/// from its textures too, if they are there. Fails: likewise; as add_texture_colours().
Result<TriangleMesh> read_mesh(std::span<const uint8_t> bytes, MeshFormat format,
                               const std::string& name, const MeshSurroundings& beside = {});

/// Reads a mesh from memory into scratch space. glTF and archives are read into memory and copied;
/// the other formats go there at once. Fails: likewise; as `budget` does.
Result<StoredMesh> read_stored_mesh(std::span<const uint8_t> bytes, MeshFormat format,
                                    const std::string& name, const ScratchSpace& space,
                                    const FileBudget& budget = {});

/// Returns how much memory read_mesh() may take for a file, but for what it asks a FileBudget.
/// Fails: as the file cannot be opened.
Result<uint64_t> reading_bytes_max(const std::filesystem::path& path, MeshFormat format);

/// Returns whether read_stored_mesh() takes all of this from scratch space.
bool is_read_into_scratch(MeshFormat format);

/// Writes by extension (PLY binary little-endian, OBJ, STL binary, GLB) to a temporary file beside
/// `path`, syncs it, and renames it into place. A failed write leaves the old file.
/// Fails: invalid_argument (unknown extension, !is_written_for_any_scan()), resource_exhausted
/// (disk full), ...; cancelled, as `budget` says.
Status write_mesh(const MeshView& mesh, const std::filesystem::path& path,
                  const FileBudget& budget = {});

}  // namespace burnish

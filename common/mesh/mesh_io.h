#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The mesh formats that can be read; kOff is read only.
enum class MeshFormat { kPly, kObj, kStl, kOff };

/// The format by file extension, any case. Fails: invalid_argument naming the path and the choices.
Result<MeshFormat> mesh_format_of_path(const std::filesystem::path& path);

/// Reads and validates a mesh. Messages name the file, the place in it, the value and the limit.
/// Fails: not_found, permission_denied, invalid_argument (damaged, truncated, hostile, empty),
/// resource_exhausted.
Result<TriangleMesh> read_mesh(const std::filesystem::path& path);

/// The same from memory, for uploads and fuzzers. `name` only serves the messages.
Result<TriangleMesh> read_mesh(std::span<const uint8_t> bytes, MeshFormat format,
                               const std::string& name);

/// Writes by extension (PLY binary little-endian, OBJ, STL binary) to a temporary file beside
/// `path`, syncs it, and renames it into place: a failed write leaves what was there before.
/// Fails: invalid_argument (unknown extension, OFF), resource_exhausted (disk full), ...
Status write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace burnish

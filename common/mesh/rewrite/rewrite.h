#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/output_buffer.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"
#include "common/mesh/rewrite/pictures/edited_pictures.h"

namespace burnish {

/// A file that a mesh was read from.
struct OriginalFile {
  std::filesystem::path path;
  MeshFormat format = MeshFormat::kPly;
  std::string name;  ///< for messages
};

/// Writes the file again with new positions, and with new normals where it has some. All else stays
/// byte for byte: a mesh that did not move gives the same file. Numbers keep their type. Facets and
/// vertices that did not move in the precision that is written keep their bytes. Takes 24 bytes a
/// vertex, and about 100 more if the file has normals. Needs: `moved` was read from these bytes.
///
/// With `pictures`, pictures in the file get the change of colours (edited_pictures.h). Null: they
/// stay.
///
/// Fails: data_loss if the mesh was not read from these bytes; as the sink does; as
/// edit_pictures(). Throws: WorkCancelled, as the output's budget says.
Status rewrite_mesh(std::span<const uint8_t> original, MeshFormat format, const std::string& name,
                    const MovedMesh& moved, OutputBuffer& output, PictureWork* pictures = nullptr);

/// Writes a moved mesh to `path` in the format of its extension, as plan_to_write() says. A failed
/// write leaves the old file. Fails: as the plan does, or if it writes several files; as
/// rewrite_mesh() and write_mesh() do, and as the original cannot be read; cancelled, as `budget`
/// says.
Status write_moved_mesh(const OriginalFile& original, const MovedMesh& moved,
                        const std::filesystem::path& path, PictureWork* pictures = nullptr,
                        const FileBudget& budget = {});

}  // namespace burnish

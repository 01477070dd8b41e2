#pragma once

#include <filesystem>

#include "common/base/status.h"
#include "common/mesh/rewrite/moved_mesh.h"

namespace burnish {

/// Writes a moved mesh as an archive: the mesh file in its own format with new numbers, and the
/// files that it names with their bytes. Warns on stderr of those that are missing.
/// Fails: as ScanBundle::open() and rewrite_mesh().
Status write_packed_mesh(const std::filesystem::path& original, const MovedMesh& moved,
                         const std::filesystem::path& archive);

/// Writes a moved mesh whose numbers lie in files beside it too: `copy`, and those files beside it.
/// Fails: as ScanBundle::open(), rewrite_mesh() and place_mesh().
Status write_spread_mesh(const std::filesystem::path& original, const MovedMesh& moved,
                         const std::filesystem::path& copy, bool replaces);

}  // namespace burnish

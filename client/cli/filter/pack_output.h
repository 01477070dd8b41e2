#pragma once

#include <filesystem>

#include "common/base/status.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

/// Writes a moved mesh as an archive: the mesh file in its own format with new numbers, and the
/// files that it names with their bytes, but for pictures with edited colours. Warns on stderr of
/// those that are missing. Fails: as ScanBundle::open() and rewrite_mesh().
Status write_packed_mesh(const std::filesystem::path& original, const MovedMesh& moved,
                         const std::filesystem::path& archive, PictureWork& pictures);

/// Writes a moved mesh that changes files beside it too, numbers or pictures: `copy`, and the files
/// that it names beside it. Fails: as ScanBundle::open(), rewrite_mesh() and place_mesh();
/// write_moved_mesh() if nothing lies beside it.
Status write_spread_mesh(const OriginalFile& original, const MovedMesh& moved,
                         const std::filesystem::path& copy, bool replaces, PictureWork& pictures);

}  // namespace burnish

#pragma once

#include <filesystem>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/mesh/mesh_format.h"
#include "server/memory/library_budget.h"
#include "server/prepare/sheets/count_texels.h"

namespace burnish {

/// Returns false only for a stored file that has no pictures by its directory. Fails: as the file
/// cannot be opened.
Result<bool> may_have_pictures(const std::filesystem::path& path, MeshFormat format);

/// Counts the texels that a stored file's triangles show, for its pages. A file that has no
/// pictures by its directory is not read. Needs: budget.ask_to_read(). Fails: as
/// read_textured_surface() and count_texels().
Result<CountedTexels> texels_of_original(const std::filesystem::path& path, MeshFormat format,
                                         const std::string& name, LibraryBudget& budget,
                                         const Progress& progress);

}  // namespace burnish

#pragma once

#include <filesystem>

#include "common/base/status.h"
#include "server/session/session.h"

namespace burnish {

/// Writes `i j k alpha1 alpha2 beta kappa1 kappa2` for every active cell, grid units for the cell
/// and user units for α and κ, under a header line that starts with '#' and gives the grid.
/// --cell-field reads it back.
Status write_fields_file(const Session& session, const std::filesystem::path& path);

}  // namespace burnish

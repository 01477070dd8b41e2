#pragma once

#include <filesystem>

#include "common/base/status.h"
#include "server/session/session.h"

namespace burnish {

/// Writes `i j k alpha1 alpha2 beta kappa1 kappa2` for every active cell: the cell in grid units, α
/// and κ in user units. A header line that starts with '#' gives the grid. --cell-field reads the
/// file back.
Status write_fields_file(const Session& session, const std::filesystem::path& path);

}  // namespace burnish

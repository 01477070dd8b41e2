#pragma once

#include <vector>

#include "common/service/session_info.h"
#include "server/session/session.h"

namespace burnish {

/// Returns one value per cell of the finest depth, with all edits so far.
std::vector<float> cell_values(const Session& session, CellValue value);

}  // namespace burnish

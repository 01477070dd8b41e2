#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

struct Hierarchy;

/// Where a trial on the CPU, which smooths the whole surface from a cold start, still moves
/// vertices after it should have settled: a spike that bends back within two cells, a flap of two
/// sheets in one cell, a crumb that shares no corner. Like crumbs.h's they move with next to no
/// energy.
///
/// Returns sets of corners, rising, the slowest spot's first: of a spot's cell and of rings of
/// cells around it, as far as they have at most kPatchCornersMax. Fails: cancelled.
Result<std::vector<std::vector<int32_t>>> find_slow_spots(
    std::shared_ptr<const PreparedMesh> prepared, std::shared_ptr<const Hierarchy> hierarchy,
    const Progress& progress = {});

}  // namespace burnish

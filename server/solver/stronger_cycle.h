#pragma once

#include <memory>

#include "server/solver/hierarchy.h"

namespace burnish {

/// Where sheets come together all over a scan, as between the two sides of a thin wall or where
/// range scans overlap, coarse functions are poor. There the depths next to the finest are
/// corrected twice (vcycle.h), and where trials are slow all the same the finest gets patches
/// (slow_spots.h); of a small scan, whose trials cost little, with fewer such places already. Other
/// scans stay as they are. Cost: up to three trials. Fails: cancelled.
Status strengthen_cycle(const PreparedMesh& prepared, const std::shared_ptr<Hierarchy>& hierarchy,
                        const Progress& progress);

}  // namespace burnish

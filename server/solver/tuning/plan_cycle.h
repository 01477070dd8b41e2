#pragma once

#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Plans the cycle for a scan. Coarse functions are poor where sheets come together all over a
/// scan, such as between the two sides of a thin wall or in overlapping range scans. There the
/// depths next to the finest are corrected twice (vcycle.h). If trials are still slow, the finest
/// depth gets patches (slow_spots.h). A small scan gets patches with fewer such places, because its
/// trials cost little. Any scan gets patches on its small components (small_components.h). Cost: up
/// to three trials. Fails: cancelled.
Result<std::shared_ptr<const CyclePlan>> plan_cycle(
    const std::shared_ptr<const PreparedMesh>& prepared,
    const std::shared_ptr<const Hierarchy>& hierarchy, const Progress& progress = {});

/// Returns whether plan_cycle() takes the memory of a session for its trials.
bool needs_trials(const Hierarchy& hierarchy);

/// Makes the hierarchy of a prepared mesh and its plan. Fails: cancelled.
Result<Multigrid> make_multigrid(std::shared_ptr<const PreparedMesh> prepared,
                                 const Progress& progress = {});

}  // namespace burnish

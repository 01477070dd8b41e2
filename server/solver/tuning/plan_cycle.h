#pragma once

#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Where sheets come together all over a scan, as between the two sides of a thin wall or where
/// range scans overlap, coarse functions are poor. There the depths next to the finest are
/// corrected twice (vcycle.h), and where trials are slow all the same the finest gets patches
/// (slow_spots.h). A small scan, whose trials cost little, gets them with fewer such places. Any
/// scan gets patches on its crumbs (crumbs.h). Cost: up to three trials. Fails: cancelled.
Result<std::shared_ptr<const CyclePlan>> plan_cycle(
    const std::shared_ptr<const PreparedMesh>& prepared,
    const std::shared_ptr<const Hierarchy>& hierarchy, const Progress& progress = {});

/// Whether plan_cycle() takes the memory of a session for its trials.
bool needs_trials(const Hierarchy& hierarchy);

/// The hierarchy of a prepared mesh and the plan for it. Fails: cancelled.
Result<Multigrid> make_multigrid(std::shared_ptr<const PreparedMesh> prepared,
                                 const Progress& progress = {});

}  // namespace burnish

#pragma once

#include "common/base/status.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/cycle/cycle_plan.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish {

// Checks of a read hierarchy before use: counts agree with one another, and every index stays
// within its array. All fail with data_loss that names the depth and the arrays.

/// Also makes the arrays that a file does not have. Needs: depths of this many elements, in their
/// order.
Status check_and_complete(Hierarchy& hierarchy, const CyclePlan& plan,
                          const PreparedMesh& prepared);

/// The part of it about rows. Needs: checked cells, corners and ties.
Status check_and_complete_stencil(HierarchyDepth& depth);

}  // namespace burnish

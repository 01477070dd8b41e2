#pragma once

#include <memory>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/cycle/cycle_plan.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish {

/// A prepared mesh, its depths, and the cycle over them: all that a solver works on. Immutable; all
/// sessions of the mesh share it.
struct Multigrid {
  std::shared_ptr<const PreparedMesh> prepared;
  std::shared_ptr<const Hierarchy> hierarchy;
  std::shared_ptr<const CyclePlan> plan;

  uint64_t byte_count() const {
    return prepared->memory_byte_count() + hierarchy->byte_count() + plan->patches.byte_count();
  }
};

}  // namespace burnish

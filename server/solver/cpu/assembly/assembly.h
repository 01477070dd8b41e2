#pragma once

#include <span>

#include "server/fields/alphas.h"
#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/hierarchy/changed_parts.h"

namespace burnish::cpu {

/// Makes the matrices and inverse diagonals of all depths, the coarsest first, and the finest
/// matrix in double if `exact` is given. A coarse depth's cells are Σ over children of Pᵀ K P.
/// The depths from `not_kept` above the finest on keep their cells' numbers. `halo`: to the other
/// shards, or null. Source: section 5.2.
void assemble(const PreparedMesh& prepared, const CellMetric& of, std::span<CpuDepth> depths,
              ExactMatrix* exact = nullptr, size_t not_kept = kDepthsNotKept, Halo* halo = nullptr);

/// Returns for how many depths a backend keeps no numbers: kDepthsNotKept, but not the border depth
/// of shards.
size_t depths_not_kept(const Hierarchy& hierarchy, const Halo* halo);

/// Brings the matrices up to a metric after a change of some cells: the same bits as assemble().
/// Adds to the rows of `changed` the corners that became pinned or free. Needs: assemble() before,
/// and find_changed_parts() of these cells with its `not_kept`.
void assemble_changed(const PreparedMesh& prepared, const CellMetric& of,
                      std::span<ChangedDepth> changed, std::span<CpuDepth> depths,
                      ExactMatrix* exact = nullptr, Halo* halo = nullptr);

}  // namespace burnish::cpu

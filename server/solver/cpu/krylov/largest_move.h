#pragma once

#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/hierarchy/points_by_cell.h"

namespace burnish::cpu {

/// Returns the largest |E a p| of any vertex: how far the step of length a along p moves it.
/// Shapes: p has one entry per corner of the grid, a one number per column. Units: cells.
double largest_move(const SparseGrid& grid, const PointsByCell& points,
                    const std::vector<Float4>& p, const Float4& a);

}  // namespace burnish::cpu

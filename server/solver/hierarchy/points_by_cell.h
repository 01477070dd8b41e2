#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "common/base/groups.h"
#include "common/evaluation/evaluation.h"

namespace burnish {

/// The rows of E cell by cell, as EvaluationPoint::local, for work at every vertex in any order. It
/// reads memory from end to end, and a cell's corners once. The order of the file would jump about.
using PointsByCell = Groups<std::array<float, 3>>;

/// Leaves out vertices without a cell. Shapes: one point per vertex.
PointsByCell sort_by_cell(std::span<const EvaluationPoint> points, int32_t cell_count);

}  // namespace burnish

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/evaluation/evaluation.h"

namespace burnish {

/// The rows of E cell by cell, for what is done at every vertex in whatever order: memory is read
/// from end to end and a cell's corners once, where vertices in the order of their file jump about.
struct PointsByCell {
  std::vector<int32_t> start;               ///< cells + 1, into `local`
  std::vector<std::array<float, 3>> local;  ///< EvaluationPoint::local
};

/// Vertices without a cell are left out. Shapes: one point per vertex.
PointsByCell sort_by_cell(std::span<const EvaluationPoint> points, int32_t cell_count);

}  // namespace burnish

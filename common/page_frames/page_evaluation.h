#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/evaluation/evaluation.h"
#include "common/grid/sparse_grid.h"
#include "common/page_frames/page_kind.h"
#include "common/page_frames/shown_pages.h"

namespace burnish {

/// Places of one page's values in a session's grid. A server makes it once per page, depth and
/// kind, and shares it among the clients that show the page.
struct PageEvaluation {
  ShownPage shown;
  std::vector<EvaluationPoint> points;  ///< one per value

  uint64_t byte_count() const {
    return points.capacity() * sizeof(points[0]) + shown.layout->byte_count();
  }
};

/// Finds the values of a page in the grid of the session's depth. The point of a vertex follows
/// from its position alone, so that all pages agree on the vertices that they share.
/// - kVertices: a vertex whose cell is not in the grid takes a cell that touches it, within half a
///   lattice step or 1e-6 cell. A vertex without such a cell does not move.
/// - kCorners: a corner that is not in the grid takes the value of a neighbour along an axis, the
///   first in the grid of -x, +x, -y, +y, -z, +z. Without one it does not move. Such corners hardly
///   weigh on a vertex: the vertex lies on a plane of its cell.
/// Needs: depth of the grid <= bits of the page's lattice.
PageEvaluation make_page_evaluation(const Page& page, int bits, const SparseGrid& grid,
                                    PageFrameKind kind);

}  // namespace burnish

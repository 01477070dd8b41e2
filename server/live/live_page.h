#pragma once

#include <cstdint>
#include <vector>

#include "common/page_frames/page_evaluation.h"
#include "common/pages/page.h"
#include "common/pages/page_grid.h"
#include "server/memory/memory_need.h"
#include "server/memory/quota.h"

namespace burnish {

/// A vertex of a page, and where it is on the pages' lattice.
struct PlacedVertex {
  Vec3i position;
  uint16_t vertex = 0;
};

/// One page of a scan in the grid of one mesh, as frames of one kind need it. Clients share it.
struct LivePage {
  PageFrameKind kind = PageFrameKind::kVertices;
  PageEvaluation evaluation;
  PageSize size;
  std::vector<int32_t> cells;  ///< that hold its vertices, each once, rising
  std::vector<Rgba8> colours;  ///< of the vertices, if this is a page of colours of kind kVertices
  PageGrid lattice;            ///< of the scan's pages
  std::vector<PlacedVertex> edge_vertices;  ///< those that may lie on a rim; none of colours
  Quota::Share memory;                      ///< share of the server's memory

  PageId number() const { return evaluation.shown.page; }
  uint64_t byte_count() const {
    return sizeof(LivePage) + evaluation.byte_count() + cells.capacity() * sizeof(cells[0]) +
           colours.capacity() * sizeof(colours[0]) +
           edge_vertices.capacity() * sizeof(edge_vertices[0]);
  }
};

/// Measures a page. `has_rims`: of the scan. Needs: depth <= bits of the page's lattice.
PageSize measure_page(const Page& page, int bits, int depth, bool has_rims);

/// Finds the page in the grid. Takes no share of the memory. Needs: as make_page_evaluation().
LivePage make_live_page(const Page& page, const PageSize& size, const PageGrid& lattice,
                        const SparseGrid& grid, PageFrameKind kind);

}  // namespace burnish

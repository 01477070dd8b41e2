#pragma once

#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/base/types.h"
#include "common/mesh/statistics/statistics.h"
#include "common/pages/page_grid.h"
#include "server/prepare/pages/page_texels.h"

namespace burnish {

/// A scan whose pages are made. The spans belong to the caller.
struct PagesInput {
  std::span<const Vec3d> vertices;  ///< file units
  std::span<const Triangle> triangles;
  std::span<const Rgba8> colours;  ///< empty, or one per vertex
  const MeshStatistics& statistics;
  PageTexels texels = {};
};

/// The vertices of a scan on the lattice of its pages.
struct PageVertices {
  PageGrid grid;
  ScratchArray<Vec3i> positions;  ///< per vertex of the scan, steps
  /// Per vertex the least vertex at the same place. Edits move all vertices of one place together.
  /// Level 0 joins those that look alike (common/mesh/agreeing_vertices.h). Coarser levels join
  /// all: a scan without shared vertices, as some programs write, would else fall into single
  /// triangles there.
  ScratchArray<uint32_t> joined;
};

/// Chooses the cube of all grids of the scan, and steps of at most 1/256 of the mean edge where
/// kPageGridBitsMax allows it.
PageGrid choose_page_grid(const MeshStatistics& statistics);

/// The vertices of a scan in steps, and which of them lie on a plane and were put below it: a bit
/// for each axis.
struct GridPlaces {
  ScratchArray<Vec3i> positions;
  ScratchArray<uint8_t> below;
};

/// Rounds every vertex as place_vertices() does. The statistics are not read.
/// Throws: WorkCancelled.
GridPlaces place_on_grid(const PagesInput& scan, const PageGrid& grid, const ScratchSpace& space,
                         const LoopPart& part = kUnheardLoop);

/// Rounds every vertex down to a step. A vertex on a plane between cells goes to the side on which
/// its triangles lie, so that its cell holds surface at every depth.
/// Deterministic: the same bits for any number of threads. Throws: WorkCancelled.
PageVertices place_vertices(const PagesInput& scan, const ScratchSpace& space,
                            const LoopPart& part = kUnheardLoop);

}  // namespace burnish

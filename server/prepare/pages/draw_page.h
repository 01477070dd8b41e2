#pragma once

#include "common/pages/directory.h"
#include "common/pages/page.h"
#include "server/prepare/pages/vertex_attributes.h"

namespace burnish {

/// The input of the pages of one level.
struct LevelToDraw {
  const CutLevel& cut;
  std::span<const PageId> finer;  ///< per triangle the page that it replaces; empty at level 0
  std::span<const uint8_t> shared;
  const PageVertices& vertices;
  const VertexAttributes& attributes;
};

/// Makes a page as clients get it. Border vertices come first. Level 0 has normals of border
/// vertices alone; coarser levels have all, as the finer surface shades them.
Page draw_page(const LevelToDraw& level, size_t page, PageId id);

/// Returns the sphere around a page; error and edge are zero.
PageBounds sphere_around(const Page& page, const PageGrid& grid);

/// Returns the mean edge of triangles, file units.
float mean_edge(std::span<const Triangle> triangles, const PageVertices& vertices);

}  // namespace burnish

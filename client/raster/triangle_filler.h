#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/raster/page_projection.h"
#include "client/raster/visibility.h"
#include "common/pages/page.h"

namespace burnish {

/// Triangles of one page, projected.
struct ScreenTriangles {
  const ScreenVertex* vertices = nullptr;
  std::span<const PageTriangle> triangles;
  uint32_t first_id = 0;  ///< triangle_id() of the first one
};

/// Puts triangles into a picture's visibility. Both sides are seen. Exactly one of the
/// triangles that share an edge covers a sample on it. `is_shared`: other threads fill the same
/// picture. Triangles with a vertex that is_beyond are not filled; returns how many numbers of such
/// triangles, counted from the first one, it has written to `left`. Needs: room for all.
int fill_triangles(Visibility& visibility, const ColumnRange& columns, bool is_shared,
                   const ScreenTriangles& triangles, uint16_t* left);

/// Fills one triangle of any size within the guard.
void fill_triangle(Visibility& visibility, const ColumnRange& columns, bool is_shared,
                   const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                   uint32_t id);

}  // namespace burnish

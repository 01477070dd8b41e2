#pragma once

#include <array>

#include "client/raster/page_projection.h"
#include "client/raster/visibility.h"
#include "common/base/types.h"

namespace burnish {

/// Fills what lies behind the near plane, and within the guard, of a triangle with a vertex that
/// is_beyond. Its edges meet those of its neighbours. Needs: `projected` is what
/// project_vertices() makes of the corners.
void fill_clipped(Visibility& visibility, const PageProjection& projection,
                  const ColumnRange& columns, bool is_shared, const std::array<Vec3f, 3>& corners,
                  const std::array<ScreenVertex, 3>& projected, uint32_t id);

}  // namespace burnish

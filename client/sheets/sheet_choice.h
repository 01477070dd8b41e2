#pragma once

#include <cstddef>
#include <cstdint>

#include "client/pages/page_view.h"
#include "client/sheets/known_sheets.h"

namespace burnish {

/// Texels that a picture needs for a pixel, along a side: while it moves, and at rest.
inline constexpr float kTexelsPerPixelMoving = 0.8f;
inline constexpr float kTexelsPerPixelStill = 1.2f;

/// Returns the density at which a page has `texels_per_pixel` where it comes nearest to the eye;
/// texels per file unit. `largest_move`: of a vertex, file units.
float needed_density(const PageView& view, const PageBounds& bounds, float largest_move,
                     float texels_per_pixel);

/// Returns the halving of the coarsest sheet that has this density, or 0 if none has.
/// Needs: a page with sheets.
uint8_t coarsest_enough(const SheetFacts& facts, float needed);

/// Returns about how many bytes a texture has in memory: its levels, and the charts of a full page.
uint64_t texture_bytes(const SheetEntry& sheet);

}  // namespace burnish

#include "client/sheets/sheet_choice.h"

#include <cmath>

#include "common/base/limits.h"
#include "common/base/types.h"

namespace burnish {

float needed_density(const PageView& view, const PageBounds& bounds, float largest_move,
                     float texels_per_pixel) {
  return texels_per_pixel * view.pixels_at_one / distance_to(view, bounds, largest_move);
}

uint8_t coarsest_enough(const SheetFacts& facts, float needed) {
  uint8_t halving = 0;
  while (halving + 1U < facts.sheets.size() &&
         std::ldexp(facts.charts.density, -(halving + 1)) >= needed)
    ++halving;
  return halving;
}

uint64_t texture_bytes(const SheetEntry& sheet) {
  const uint64_t finest = uint64_t{sheet.width} * sheet.height * sizeof(Rgba8);
  return finest + finest / 4 + finest / 16 + kPageTrianglesMax * sizeof(uint16_t);
}

}  // namespace burnish

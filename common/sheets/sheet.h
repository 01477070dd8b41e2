#pragma once

#include <cstdint>
#include <vector>

#include "common/base/types.h"
#include "common/pages/page.h"
#include "common/sheets/sheet_layout.h"

namespace burnish {

/// The texels of a page at one density.
struct Sheet {
  PageId page = 0;
  uint8_t halving =
      0;              ///< 0 is the finest sheet of the page; each further one has half its density
  float density = 0;  ///< texels per file unit
  SheetLayout layout;
  std::vector<Rgba8> texels;  ///< row by row; an alpha of 255 is opaque
};

}  // namespace burnish

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/edit/protect.h"
#include "tests/common/mesh/rewrite/photo_grid.h"
#include "tests/server/prepare/sheets/painted_ball.h"

namespace burnish {

/// Returns an archive of a square whose charts are photos, with this picture.
inline std::vector<uint8_t> zip_of(const PhotoGrid& grid, const std::string& png) {
  std::string obj = grid.obj();
  const std::string library = "skin.mtl";
  return zip_of(obj.replace(obj.find(library), library.size(), "ball.mtl"), png);
}

inline std::vector<uint8_t> zip_of(const PhotoGrid& grid) {
  return zip_of(grid, png_of(grid.picture()));
}

/// Protects the left half of such a square.
inline Protect left_half(int side) {
  LassoRegion lasso;
  lasso.view_projection = {2.0 / side, 0, 0, -1, 0, 2.0 / side, 0, -1, 0, 0, 0.1, 0, 0, 0, 0, 1};
  lasso.polygon = {{-2, -2}, {0, -2}, {0, 2}, {-2, 2}};
  lasso.through = true;
  return {.way = lasso};
}

}  // namespace burnish

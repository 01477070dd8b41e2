#pragma once

#include "common/view/view.h"
#include "common/view/view_format.h"
#include "tests/common/frame_codec/small_scan.h"

namespace burnish {

/// Returns the small scan as a prepared mesh would give it.
inline ViewSource small_source() {
  const SmallScan& scan = small_scan();
  static const std::vector<MortonKey> cells = [&scan] {
    std::vector<MortonKey> keys;
    for (const GridKey& key : scan.grid.cells) keys.push_back(key.place);
    return keys;
  }();
  return {.frame = scan.frame,
          .length_unit = 2,
          .cells = cells,
          .mesh = {scan.mesh.vertices, scan.mesh.triangles, scan.points},
          .colours = scan.mesh.colours};
}

}  // namespace burnish

#pragma once

#include <vector>

#include "client/raster/page_projection.h"
#include "client/raster/visibility.h"
#include "client/raster/work_crew.h"

namespace burnish {

/// Keeps the farthest sample in each tile of a picture. Things behind all tiles of their box are
/// hidden.
class NearnessTiles {
 public:
  void measure(const Visibility& visibility, WorkCrew& crew);

  /// Returns true if nothing in the box can be seen. Never says so of anything that is seen.
  bool hide(const ScreenBox& box) const;

 private:
  int across_ = 0;
  std::vector<float> farthest_;  // nearness; 0 where a sample shows nothing
};

}  // namespace burnish

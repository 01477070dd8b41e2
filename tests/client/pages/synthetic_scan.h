#pragma once

#include <cstdint>
#include <vector>

#include "client/scene/camera.h"
#include "client/scene/image.h"
#include "common/base/groups.h"
#include "common/pages/cut.h"
#include "common/pages/directory.h"
#include "common/pages/page.h"

namespace burnish {

struct SyntheticScanOptions {
  int side = 32;                ///< pages of level 0 along each side
  int triangles_per_page = 64;  ///< of level 0, give or take a quarter
  uint64_t seed = 1;
};

/// A directory and pages without geometry: a unit square cut into rectangles, level by level, each
/// level half as many. Borders move from level to level. A page's patch lies where its rectangle
/// and the finer page's meet, so that the drawn area of a cut can be measured.
struct SyntheticScan {
  PageDirectory directory;
  Groups<PagePatch> patches;                ///< by page
  std::vector<Eigen::AlignedBox2d> places;  ///< by page, in the unit square

  /// Returns a page with the counts and patches of the directory, and vertices all in one place.
  Page page(PageId id) const;
  DirectoryBlock block(uint32_t index) const;
  /// Returns the area of what a cut draws: 1 if it is whole and nothing lies twice.
  double drawn_area(const PageSet& set) const;
  /// Returns how many triangles a cut draws.
  uint64_t drawn_triangles(const PageSet& set) const;
};

SyntheticScan make_synthetic_scan(const SyntheticScanOptions& options = {});

inline constexpr ImageSize kFlightPicture = {1280, 720};

/// Looks straight at a place of the square, which fills the picture's height at distance 1.9.
Camera camera_over(double x, double y, double distance);

}  // namespace burnish

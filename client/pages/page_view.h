#pragma once

#include <array>

#include <Eigen/Core>

#include "client/scene/camera.h"
#include "client/scene/image.h"
#include "common/base/types.h"
#include "common/pages/directory.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// The camera, as far as the choice of pages needs it. File units, relative to
/// PageGrid::origin.
struct PageView {
  Vec3f eye = Vec3f::Zero();
  float pixels_at_one = 1;  ///< what a length of 1 measures at distance 1 in the picture's middle
  float nearest = 0;        ///< nothing nearer to the eye is drawn; above 0
  bool parallel = false;    ///< orthographic: everything is as large as at `nearest`
  /// Drawn points lie on the positive side of each: n·x + d >= 0, |n| = 1.
  std::array<Eigen::Vector4f, 6> planes;

  bool operator==(const PageView&) const = default;
};

PageView make_page_view(const Camera& camera, const ImageSize& size, const PageGrid& grid);

/// Bounds of the shown frame, all pages together.
struct FrameBounds {
  float largest_move = 0;  ///< of a vertex, file units
  float gain = 1;          ///< at least the largest β: sharpening magnifies what is left out

  bool operator==(const FrameBounds&) const = default;
};

/// Returns how near a sphere comes to the eye, PageView::nearest at least. Without perspective it
/// is PageView::nearest.
inline float distance_to(const PageView& view, const PageBounds& bounds, float largest_move) {
  if (view.parallel) return view.nearest;
  const float to_centre = (bounds.centre - view.eye).norm();
  return std::max(to_centre - bounds.radius - largest_move, view.nearest);
}

/// Returns whether a part of the sphere, grown by the largest move, may be in the picture.
bool is_visible(const PageView& view, const PageBounds& bounds, float largest_move);

/// Returns whether the whole sphere, grown by the largest move, is in the picture.
bool is_inside(const PageView& view, const PageBounds& bounds, float largest_move);

}  // namespace burnish

#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "client/pages/page_view.h"
#include "common/pages/directory.h"
#include "common/pages/page.h"

namespace burnish {

/// How fine a picture is to be. Every cut measures in full detail, so that what is a need in one is
/// comparable in the next.
struct CutTargets {
  float error_px = 1;  ///< full detail: no triangle is farther from the scan than this,
  float edge_px = 1;   ///< and the mean edge is no longer than this
  float take = 1;      ///< a page is wanted if the picture without it exceeds so many times the two
  /// A page that the last cut showed stays wanted above so many times the two. The same as `take`:
  /// the last cut is of no influence.
  float keep = 1;

  bool operator==(const CutTargets&) const = default;
};

inline constexpr float kErrorPx = 1;
inline constexpr float kEdgePx = 6;
inline constexpr float kCoarseEdgePx = 12;  // while the surface moves, and without a graphics card
inline constexpr float kFullEdgePx = 1;
/// A page that was shown counts so much more, where the last cut has an influence.
inline constexpr float kHysteresis = 0.9f;

/// Full detail of what is looked at, when nothing moves. The cut follows from the view alone.
inline CutTargets full_targets(bool is_software) {
  return {kErrorPx * kFullEdgePx / (is_software ? kCoarseEdgePx : kEdgePx), kFullEdgePx, 1, 1};
}
/// A good picture soon: while the camera moves, and until that picture is there. Full detail that
/// is here stays.
inline CutTargets prompt_targets(bool is_software) {
  CutTargets targets = full_targets(is_software);
  targets.take = (is_software ? kCoarseEdgePx : kEdgePx) / kFullEdgePx;
  return targets;
}
/// While values of all vertices come with every frame.
inline CutTargets moving_surface_targets() {
  CutTargets targets = full_targets(true);
  targets.take = kCoarseEdgePx / kFullEdgePx;
  targets.keep = kHysteresis * targets.take;
  return targets;
}

/// Returns how many times a picture without the page exceeds full detail, as if the page were in
/// view.
inline float excess_of(const PageBounds& bounds, const PageView& view, const FrameBounds& frame,
                       const CutTargets& targets) {
  const float over =
      std::max(frame.gain * bounds.error / targets.error_px, bounds.edge / targets.edge_px);
  return over * view.pixels_at_one / distance_to(view, bounds, frame.largest_move);
}

/// Cost of a page on the card: a slot, full or not.
inline constexpr uint32_t kCardBytesPerVertex = 44;  // of PageStreams (client/gl)
inline constexpr uint32_t kCardBytesPerTriangle = 12;
inline constexpr uint64_t kSlotBytes =
    kPageVerticesMax * kCardBytesPerVertex + kPageTrianglesMax * kCardBytesPerTriangle;

/// Limits of what pictures cost. A cut aims at 90 % of each, but for the directory's.
struct PageBudget {
  uint64_t triangles = 2'000'000;                            ///< drawn in a picture
  uint64_t vertices = std::numeric_limits<uint64_t>::max();  ///< of the cut: values in a frame
  uint64_t resident_bytes = 300'000'000;  ///< encoded and decoded pages in memory
  uint64_t card_bytes = 425'000'000;
  uint32_t directory_blocks = 4096;  ///< 10^6 pages, 10^9 triangles and more: about 60 MB

  uint64_t slots() const { return card_bytes / kSlotBytes; }
};

/// The budget where processors draw (client/raster): all of a scan of millions of triangles.
inline PageBudget processor_budget() {
  return {.triangles = 8'000'000};
}

/// The budget where OpenGL draws without a graphics card.
inline PageBudget software_budget() {
  return {.triangles = 150'000};
}

}  // namespace burnish

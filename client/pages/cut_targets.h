#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "client/pages/page_view.h"
#include "common/pages/directory.h"
#include "common/pages/page.h"

namespace burnish {

/// How fine a picture is to be.
struct CutTargets {
  float error_px = 1;  ///< a page is wanted if what replaces it is farther off than this,
  float edge_px = 6;   ///< or has longer edges than this
  /// A page that the last cut used stays down to this part of the two. 1: the last cut is of no
  /// influence. Pages that only stay are the first to go when a budget is short.
  float keep = 0.9f;

  bool operator==(const CutTargets&) const = default;
};

inline constexpr float kErrorPx = 1;
inline constexpr float kEdgePx = 6;
inline constexpr float kCoarseEdgePx = 12;  // while the surface moves, and without a graphics card
inline constexpr float kFullEdgePx = 1;
inline constexpr float kKeep = 0.9f;

/// While values of all vertices come with every frame.
inline CutTargets moving_surface_targets() {
  return {kErrorPx, kCoarseEdgePx, kKeep};
}
/// While nothing moves. The cut follows from the view alone.
inline CutTargets still_targets(bool is_software) {
  return {kErrorPx, is_software ? kCoarseEdgePx : kEdgePx, 1};
}
/// When nothing moves and the still cut is there: full detail of what is looked at. Edges and
/// errors shrink alike, so the still cut is a part of this one.
inline CutTargets full_targets(bool is_software) {
  const CutTargets still = still_targets(is_software);
  return {still.error_px * kFullEdgePx / still.edge_px, kFullEdgePx, 1};
}
/// While the camera moves: nothing beyond the still cut is fetched, but full detail that is here
/// stays.
inline CutTargets moving_eye_targets(bool is_software) {
  CutTargets targets = still_targets(is_software);
  targets.keep = kFullEdgePx / targets.edge_px;
  return targets;
}

/// Returns how many times over its target a picture without the page is, wherever the page is. The
/// page is needed above 1.
inline float excess_of(const PageBounds& bounds, const PageView& view, const FrameBounds& frame,
                       const CutTargets& targets) {
  const float over =
      std::max(frame.gain * bounds.error / targets.error_px, bounds.edge / targets.edge_px);
  return over * view.pixels_at_one / distance_to(view, bounds, frame.largest_move);
}

/// What a page costs on the card: a slot, full or not.
inline constexpr uint32_t kCardBytesPerVertex = 32;  // position, displacement, normal, colour
inline constexpr uint32_t kCardBytesPerTriangle = 6;
inline constexpr uint64_t kSlotBytes =
    kPageVerticesMax * kCardBytesPerVertex + kPageTrianglesMax * kCardBytesPerTriangle;

/// What pictures may cost. A cut aims at 90 % of each.
struct PageBudget {
  uint64_t triangles = 2'000'000;                            ///< drawn in a picture
  uint64_t vertices = std::numeric_limits<uint64_t>::max();  ///< of the cut: values in a frame
  uint64_t resident_bytes = 300'000'000;  ///< encoded and decoded pages in memory
  uint64_t card_bytes = 300'000'000;

  uint64_t slots() const { return card_bytes / kSlotBytes; }
};

/// The budget without a graphics card.
inline PageBudget software_budget() {
  return {.triangles = 150'000};
}

}  // namespace burnish

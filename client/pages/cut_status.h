#pragma once

#include <cstdint>
#include <string>

#include "client/pages/known_pages.h"
#include "client/pages/page_view.h"

namespace burnish {

/// Why a picture does not show full detail.
enum class CutReason {
  kNone,       ///< it does
  kLoading,    ///< pages are on their way
  kMoving,     ///< the camera or the surface moves, or has just stopped
  kFrame,      ///< more values than a frame has do not fit the link
  kServer,     ///< the server has no memory for more
  kTriangles,  ///< the budget of drawn triangles
  kMemory,     ///< the budget of memory
  kCard,       ///< the budget of memory on the card
  kFailed,     ///< pages did not come in several tries
};

/// The state of a picture, for a status line.
struct CutStatus {
  /// In the middle of the picture every triangle in view is the scan's own, or its edges are below
  /// a pixel and its distance from the scan below a sixth of one (a twelfth without a graphics
  /// card). Both are the directory's numbers: the mean edge of a page, the bound of its error. At
  /// the corners of a wide picture a pixel is up to 1.3 times as long.
  bool is_full_detail = false;
  CutReason reason = CutReason::kLoading;  ///< kNone if and only if it is full detail
  uint64_t triangles_drawn = 0;
  uint64_t triangles_in_view = 0;  ///< of the scan; an estimate where the directory is not known
  uint64_t bytes_left = 0;         ///< to load for this view
  uint64_t failed_items = 0;       ///< given up, of those that this view wants

  /// Returns drawn over in view, at most 1.
  double drawn_part() const;
};

/// Returns a short line: "full detail", or "12 % of 2.25 M triangles: loading, 1.3 MB left".
std::string status_text(const CutStatus& status);

/// Returns what a picture without full detail is: "simplified, 40 %"; nothing of another.
std::string simplified_text(const CutStatus& status);

/// Returns how many triangles of the scan may be in the picture. Counts pages whole. Takes the
/// scan's mean for pages that are not known.
uint64_t scan_triangles_in_view(const KnownPages& known, const PageView& view, float largest_move);

}  // namespace burnish

#pragma once

#include <memory>

#include "client/live/surface_frame.h"
#include "common/page_frames/page_corners.h"
#include "common/page_frames/page_frame_state.h"
#include "common/page_frames/page_kind.h"
#include "common/page_frames/shown_pages.h"

namespace burnish {

/// Decides, together with a page, which values the page has in frames.
struct FrameTerms {
  PageFrameKind kind = PageFrameKind::kVertices;
  int bits = 0;   ///< of the pages' lattice
  int depth = 0;  ///< of the session, at most `bits`
};

/// A page as the frames of one stream carry it.
struct FramedPage {
  std::shared_ptr<const Page> page;
  ShownPage shown;
  std::shared_ptr<const PageCorners> corners;  ///< null for the kind of vertices
};

FramedPage frame_page(std::shared_ptr<const Page> page, const FrameTerms& terms);

/// Evaluates a frame's values at the vertices. Needs: the page's tile in a frame of these terms.
std::shared_ptr<const PageMove> move_of(const FramedPage& framed, const PageTile& tile,
                                        const FrameTerms& terms);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>

#include "common/page_frames/page_kind.h"
#include "common/page_frames/shown_pages.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Returns the bytes that one session over a mesh will take for itself, with a gesture's copy of
/// its fields and a search for rims. Works before the solver is made. Accuracy: no less than the
/// session takes on the CPU backend. Less than twice that from some ten thousand corners on, if a
/// cell has few triangles.
uint64_t predict_session_bytes(const Multigrid& on);

/// The host's memory for one session.
struct SessionNeed {
  uint64_t opening = 0;  ///< bytes while it opens
  uint64_t open = 0;     ///< bytes from then on, in the sense of predict_session_bytes()
};

/// Returns the need of a session whose system lies on so many devices; 0: on processors. Several
/// devices need the scan a second time, cut into shards, until these are copied.
SessionNeed predict_session_need(const Multigrid& on, int devices);

/// The size of a page, whatever the kind of frames.
struct PageSize {
  uint32_t vertices = 0;
  uint32_t triangles = 0;
  uint32_t corners = 0;        ///< count_page_corners()
  uint32_t edge_vertices = 0;  ///< that may lie on a rim
};

/// Returns the bytes that a page in a mesh's grid will take for the frames of one kind, for all
/// clients together. Accuracy: no less than it takes. Less than twice that for pages of a surface.
uint64_t predict_page_bytes(const PageSize& page, PageFrameKind kind);

/// Returns the bytes that a client will take for the lists of its pages, for the frames that its
/// encoder remembers and for one in the making. Accuracy: no less than it takes while displacements
/// are below 128 cells. Less than twice what a client takes that acknowledges late.
uint64_t predict_client_bytes(std::span<const ShownPage> pages);

}  // namespace burnish

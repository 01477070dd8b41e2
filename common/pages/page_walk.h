#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/pages/page.h"

namespace burnish {

// The walk over a page's triangles
//
// The walk visits each triangle once, from neighbour to neighbour. It keeps a list of edges. An
// edge goes from a vertex to a vertex along the side of a visited triangle, whose third vertex is
// the edge's apex. Edges form rings: each has one before it and one after it. The walk takes the
// edges in the order in which they came. For each that is open it takes one step:
//
//     0  new     a triangle (to, from, w) lies at the edge; w is a vertex not met before
//     1  left    the same; w is where the edge before begins
//     2  right   the same; w is where the edge after ends
//     3  none    no triangle lies at the edge
//     4  named   the same as 0; w is one of the named vertices
//
// A new vertex takes the next number. A named vertex is stored as the distance to the newest
// vertex, which is at distance 0. When no edge is open, the walk starts anew with a triangle (a, b,
// c):
//
//   8 + n  start   bit 0, 1, 2 of n: a, b, c is a named vertex, else a new one
//
// A start adds the edges ab, bc, ca, a ring. A triangle at an edge (from, to) closes that edge. In
// its place the ring has (from, w) and (w, to), which come in this order. There are two exceptions:
// If the edge before begins at w, it closes, and (from, w) does not come. If the edge after ends at
// w, it closes, and (w, to) does not come. Closed edges leave the ring.
//
// If both edges come, and the newest older edge that begins at w is open, the rings are cut at w:
// that edge y now follows (from, w), and (w, to) follows the edge that was before y.
//
// The steps end with the last triangle, whatever is open then.
//
// A turn says whether a triangle names its patch (1) or has that of the triangle at its edge, or at
// a start that of the triangle before (0). The first triangle has patch 0 unless it names another.
//
// A new vertex at an edge is predicted as from + to - apex, in a start as the vertex before.

/// The walk in the form that is stored. Nothing is checked.
struct WalkCode {
  std::vector<uint8_t> steps;
  std::vector<uint16_t> named_vertices;
  std::vector<uint8_t> turns;  ///< one per triangle
  std::vector<uint16_t> named_patches;
};

/// The three vertices that predict one: a + b - c. In a start all are the vertex before.
struct WalkOrigin {
  uint16_t a = 0;
  uint16_t b = 0;
  uint16_t c = 0;
};

/// Results of the code. Vertices and triangles are in the order of the walk.
struct PageWalk {
  std::vector<PageTriangle> triangles;
  std::vector<uint16_t> patches;    ///< per triangle, an index into the page's patches
  std::vector<WalkOrigin> origins;  ///< per vertex
};

/// A walk, and which vertex of the page is each of the walk's.
struct PlannedWalk {
  WalkCode code;
  std::vector<uint16_t> sources;  ///< per vertex of the walk
};

/// Needs: check_page() is ok.
PlannedWalk plan_walk(const Page& page);

/// Safe for any code. Fails: data_loss that names the step or what is left over.
Result<PageWalk> follow_walk(const WalkCode& code, size_t vertices, size_t patches);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/scratch_array.h"
#include "common/base/types.h"

namespace burnish {

/// An edge of one triangle, by the least vertices at its ends.
struct RimEdge {
  uint32_t from, to;
};

/// The edges of a surface (see SurfaceTriangles). Vertices at one place count as one: seams of
/// textures and soups of triangles hang together there.
struct EdgeCensus {
  bool is_closed = false;        ///< each edge is passed as often one way as the other
  std::vector<RimEdge> rims;     ///< edges of exactly one triangle, by their lesser end
  ScratchArray<uint32_t> place;  ///< per vertex: the least vertex at its place
};

/// Shapes: indices of `vertices`. Cost: linear time; edge_census_bytes().
/// Needs: at most kVerticesMax vertices.
EdgeCensus take_edge_census(std::span<const Vec3d> vertices, std::span<const Triangle> triangles);

/// Returns the bytes that a census takes at its peak, with its result. `rims`: no fewer than it
/// finds, such as the edges of one triangle.
uint64_t edge_census_bytes(uint64_t vertices, uint64_t triangles, uint64_t rims);

}  // namespace burnish

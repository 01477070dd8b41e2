#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// An edge of one triangle, by the least vertices at its ends.
struct RimEdge {
  uint32_t from, to;
};

/// The edges of a mesh whose vertices at one place count as one: seams of textures and soups of
/// triangles hang together there.
struct EdgeCensus {
  bool is_closed = false;           ///< each edge is passed as often one way as the other
  std::vector<RimEdge> rims;        ///< edges of exactly one triangle, by triangle
  std::vector<Triangle> triangles;  ///< with the least vertex of each place
  std::vector<uint32_t> place;      ///< per vertex: the least vertex at its place
};

/// Shapes: indices of `vertices`. Cost: 24 bytes of scratch per triangle, some sorts.
EdgeCensus take_edge_census(std::span<const Vec3d> vertices, std::span<const Triangle> triangles);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/evaluation/evaluation.h"

namespace burnish {

/// A scan at full resolution, as a prepared mesh holds it.
struct DetailedMesh {
  std::span<const Vec3d> vertices;
  std::span<const Triangle> triangles;
  std::span<const EvaluationPoint> evaluation;  ///< one per vertex
};

/// A coarser mesh for clients without room for the scan. Its vertices are some of the scan's, with
/// their evaluation points in the same grid: the same coefficients move both.
struct Proxy {
  std::vector<uint32_t> source;             ///< the scan's vertex behind each vertex
  std::vector<Triangle> triangles;          ///< indices into `source`
  std::vector<EvaluationPoint> evaluation;  ///< one per vertex
};

/// At most `triangles_max` triangles; all of them where the scan has no more. Vertices that no
/// triangle references are left out. Edges collapse along the surface as far as its topology
/// allows, and beyond that by clusters of vertices.
/// Needs: triangles_max > 0. Cost: about a second per million triangles.
Proxy make_proxy(const DetailedMesh& mesh, size_t triangles_max);

/// What a client's wish for at most so many triangles counts as, so that close wishes share one
/// proxy: two significant bits of it, rounded down, and no less than 1000. 0, the whole scan,
/// stays.
uint64_t rounded_triangles_max(uint64_t triangles_max);

}  // namespace burnish

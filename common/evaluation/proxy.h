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
  std::vector<uint32_t> source;             ///< the scan's vertex for each vertex
  std::vector<Triangle> triangles;          ///< indices into `source`
  std::vector<EvaluationPoint> evaluation;  ///< one per vertex
};

/// Makes a proxy of at most `triangles_max` triangles; a scan with no more keeps all of them.
/// Vertices that no triangle references are left out. Edges collapse along the surface as far as
/// its topology allows; after that, clusters of vertices merge.
/// Needs: triangles_max > 0. Cost: about a second per million triangles.
Proxy make_proxy(const DetailedMesh& mesh, size_t triangles_max);

/// Rounds a client's wish for at most `triangles_max` triangles, so that close wishes share one
/// proxy: down to two significant bits, but not below 1000. 0, the whole scan, stays 0.
uint64_t rounded_triangles_max(uint64_t triangles_max);

}  // namespace burnish

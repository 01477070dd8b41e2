#include "server/prepare/pages/page_vertices.h"

#include <algorithm>
#include <cmath>

#include "common/base/parallel.h"
#include "common/grid/grid.h"
#include "server/prepare/pages/plane_sides.h"

namespace burnish {

namespace {

constexpr double kStepsPerMeanEdge = 256;

struct HashedVertex {
  uint64_t hash;
  uint32_t vertex;
};

uint64_t hash_of(const Vec3i& p) {
  uint64_t hash = static_cast<uint64_t>(p.x()) << 40 ^ static_cast<uint64_t>(p.y()) << 20 ^
                  static_cast<uint64_t>(p.z());
  hash = (hash ^ hash >> 32) * 0xd6e8feb86659fd93;
  return hash ^ hash >> 32;
}

bool is_before(const Vec3i& a, const Vec3i& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

std::vector<uint32_t> join_places(const std::vector<Vec3i>& positions) {
  std::vector<HashedVertex> sorted(positions.size());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < sorted.size(); ++v)
    sorted[v] = {hash_of(positions[v]), static_cast<uint32_t>(v)};
  parallel_sort(sorted.begin(), sorted.end(), [&](const HashedVertex& a, const HashedVertex& b) {
    if (a.hash != b.hash) return a.hash < b.hash;
    const Vec3i &p = positions[a.vertex], &q = positions[b.vertex];
    return p == q ? a.vertex < b.vertex : is_before(p, q);
  });
  std::vector<uint32_t> joined(positions.size());
  uint32_t first = 0;
  for (const HashedVertex& hashed : sorted) {
    if (positions[hashed.vertex] != positions[first] || &hashed == &sorted[0])
      first = hashed.vertex;
    joined[hashed.vertex] = first;
  }
  return joined;
}

}  // namespace

PageGrid choose_page_grid(const MeshStatistics& statistics) {
  const GridFrame frame = make_grid_frame(statistics.box_min, statistics.box_max, kDepthMin);
  PageGrid grid;
  grid.origin = frame.origin;
  grid.side = frame.cell_size * frame.cells_per_side();
  const double bits = std::log2(grid.side * kStepsPerMeanEdge / statistics.mean_edge_length);
  grid.bits = static_cast<int>(std::clamp<double>(std::ceil(bits), kDepthMax, kPageGridBitsMax));
  return grid;
}

PageVertices place_vertices(const PagesInput& scan) {
  PageVertices placed;
  placed.grid = choose_page_grid(scan.statistics);
  placed.positions.resize(scan.vertices.size());
  const std::vector<uint8_t> below = find_vertices_below_planes(scan, placed.grid);
  const double scale = placed.grid.steps() / placed.grid.side;
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < scan.vertices.size(); ++v) {
    Vec3i& position = placed.positions[v] = placed.grid.quantise(scan.vertices[v]);
    for (int axis = 0; axis < 3; ++axis)
      if (below[v] >> axis & 1)
        position[axis] = static_cast<int>(std::round(
                             (scan.vertices[v][axis] - placed.grid.origin[axis]) * scale)) -
                         1;
  }
  placed.joined = join_places(placed.positions);
  return placed;
}

}  // namespace burnish

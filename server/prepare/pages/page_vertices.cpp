#include "server/prepare/pages/page_vertices.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "common/base/limits.h"
#include "common/grid/grid.h"
#include "server/prepare/pages/plane_sides.h"
#include "server/prepare/radix_sort.h"

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

// Sorts vertices by the hash of their place, then by place, then by number.
ScratchArray<HashedVertex> sort_by_place(std::span<const Vec3i> positions,
                                         const ScratchSpace& space, const LoopPart& part) {
  ScratchArray<HashedVertex> sorted(space, positions.size()), spare(space, positions.size());
  parallel_for_heard(part, sorted.size(), [&](size_t v) {
    sorted[v] = {hash_of(positions[v]), static_cast<uint32_t>(v)};
  });
  radix_sort(std::span(sorted.data(), sorted.size()), std::span(spare.data(), spare.size()),
             std::mem_fn(&HashedVertex::hash), part);
  const auto is_earlier = [&](const HashedVertex& a, const HashedVertex& b) {
    const Vec3i &p = positions[a.vertex], &q = positions[b.vertex];
    return p != q ? is_before(p, q) : a.vertex < b.vertex;
  };
  // Different places of one hash are rare.
  size_t begin = 0;
  for_each_heard(part, sorted.size(), [&](size_t i) {
    if (i + 1 < sorted.size() && sorted[i + 1].hash == sorted[begin].hash) return;
    sort_heard(part, sorted.begin() + begin, sorted.begin() + i + 1, is_earlier);
    begin = i + 1;
  });
  return sorted;
}

ScratchArray<uint32_t> join_places(std::span<const Vec3i> positions, const ScratchSpace& space,
                                   const LoopPart& part) {
  const ScratchArray<HashedVertex> sorted = sort_by_place(positions, space, part);
  ScratchArray<uint32_t> joined(space, positions.size());
  uint32_t first = 0;
  for_each_heard(part, sorted.size(), [&](size_t i) {
    const uint32_t vertex = sorted[i].vertex;
    if (positions[vertex] != positions[first] || i == 0) first = vertex;
    joined[vertex] = first;
  });
  return joined;
}

Vec3i place_vertex(const Vec3d& vertex, const PlaneSides& sides, const PageGrid& grid) {
  Vec3i position = grid.quantise(vertex);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(sides.on >> axis & 1)) continue;
    const double plane = std::round((vertex[axis] - grid.origin[axis]) / grid.step());
    position[axis] =
        static_cast<int>(std::clamp(plane, 0.0, grid.steps() - 1.0)) - (sides.below >> axis & 1);
  }
  return position;
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

GridPlaces place_on_grid(const PagesInput& scan, const PageGrid& grid, const ScratchSpace& space,
                         const LoopPart& part) {
  GridPlaces places;
  places.positions = ScratchArray<Vec3i>(space, scan.vertices.size());
  places.below = ScratchArray<uint8_t>(space, scan.vertices.size());
  const ScratchArray<PlaneSides> sides = find_plane_sides(scan, grid, space, part);
  parallel_for_heard(part, scan.vertices.size(), [&](size_t v) {
    places.positions[v] = place_vertex(scan.vertices[v], sides[v], grid);
    places.below[v] = sides[v].on & sides[v].below;
  });
  return places;
}

PageVertices place_vertices(const PagesInput& scan, const ScratchSpace& space,
                            const LoopPart& part) {
  PageVertices placed;
  placed.grid = choose_page_grid(scan.statistics);
  placed.positions = place_on_grid(scan, placed.grid, space, part).positions;
  placed.joined = join_places(placed.positions, space, part);
  return placed;
}

}  // namespace burnish

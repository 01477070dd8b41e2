#include "server/prepare/pages/cluster_vertices.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "common/grid/morton.h"

namespace burnish {

namespace {

constexpr float kCoarser = 1.4f;     // from one lattice to the next
constexpr float kCellsPerSide = 64;  // of the finest lattice

// Returns for each vertex the vertex that it is joined with.
std::vector<uint32_t> join_in_cells(const PagePiece& piece, const Vec3f& origin, float cell) {
  std::unordered_map<MortonKey, uint32_t> first_in_cell;
  std::vector<uint32_t> joined(piece.positions.size());
  for (uint32_t v = 0; v < joined.size(); ++v) {
    const Vec3i at = ((piece.positions[v] - origin) / cell).cast<int>();
    joined[v] = piece.locked[v] ? v : first_in_cell.try_emplace(morton_key(at), v).first->second;
  }
  return joined;
}

std::vector<Triangle> join(const std::vector<Triangle>& triangles,
                           const std::vector<uint32_t>& joined) {
  std::vector<Triangle> left;
  for (const Triangle& t : triangles) {
    const Triangle moved = {joined[t[0]], joined[t[1]], joined[t[2]]};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) left.push_back(moved);
  }
  return left;
}

float area_of(const PagePiece& piece, const Triangle& t) {
  const Vec3f &a = piece.positions[t[0]], &b = piece.positions[t[1]], &c = piece.positions[t[2]];
  return (b - a).cross(c - a).norm() / 2;
}

float longest_edge(const PagePiece& piece, const Triangle& t) {
  float longest = 0;
  for (int corner = 0; corner < 3; ++corner)
    longest = std::max(longest,
                       (piece.positions[t[corner]] - piece.positions[t[(corner + 1) % 3]]).norm());
  return longest;
}

}  // namespace

SimplePiece cluster_vertices(const PagePiece& piece, size_t triangles_wanted) {
  Vec3f low = piece.positions[0], high = low;
  for (const Vec3f& p : piece.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const float side = std::max((high - low).maxCoeff(), 1.0f);
  SimplePiece simple{piece.triangles};
  for (float cell = side / kCellsPerSide; simple.triangles.size() > triangles_wanted;
       cell *= kCoarser) {
    simple.triangles = join(piece.triangles, join_in_cells(piece, low, cell));
    simple.error = std::min(cell * std::sqrt(3.0f), (high - low).norm());
    if (cell > side) break;  // one cell holds all
  }
  return simple;
}

SimplePiece drop_small_triangles(const PagePiece& piece, size_t triangles_wanted) {
  std::vector<uint32_t> by_area(piece.triangles.size());
  std::iota(by_area.begin(), by_area.end(), 0);
  std::vector<float> areas;
  for (const Triangle& t : piece.triangles) areas.push_back(area_of(piece, t));
  std::ranges::sort(by_area, [&](uint32_t a, uint32_t b) {
    return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
  });
  const auto end = by_area.begin() + std::min(by_area.size(), triangles_wanted);
  SimplePiece simple;
  for (auto dropped = end; dropped != by_area.end(); ++dropped)
    simple.error = std::max(simple.error, longest_edge(piece, piece.triangles[*dropped]));
  std::sort(by_area.begin(), end);
  for (auto kept = by_area.begin(); kept != end; ++kept)
    simple.triangles.push_back(piece.triangles[*kept]);
  return simple;
}

}  // namespace burnish

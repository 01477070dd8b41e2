#include "common/page_frames/page_corners.h"

#include <algorithm>

#include "common/base/check.h"
#include "common/base/limits.h"
#include "common/evaluation/evaluation.h"

namespace burnish {

namespace {

// Returns the cells of the positions, strictly rising.
std::vector<MortonKey> cells_of(std::span<const Vec3i> positions, int bits, int depth) {
  std::vector<MortonKey> cells;
  cells.reserve(positions.size());
  for (const Vec3i& position : positions)
    cells.push_back(morton_key(cell_place(position, bits, depth).cell));
  std::ranges::sort(cells);
  cells.erase(std::ranges::unique(cells).begin(), cells.end());
  return cells;
}

std::vector<MortonKey> corners_of(std::span<const MortonKey> cells) {
  std::vector<MortonKey> places;
  places.reserve(cells.size() * kCornersPerCell);
  for (const MortonKey cell : cells)
    for (int a = 0; a < kCornersPerCell; ++a)
      places.push_back(morton_key(morton_point(cell) + corner_offset(a)));
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
  return places;
}

}  // namespace

CellPlace cell_place(const Vec3i& position, int bits, int depth) {
  const int shift = bits - depth;
  BURNISH_CHECK(shift >= 0, "the lattice is coarser than the cells");
  CellPlace place;
  for (int axis = 0; axis < 3; ++axis) {
    place.cell[axis] = position[axis] >> shift;
    const int within = position[axis] - (place.cell[axis] << shift);
    place.local[axis] = (static_cast<float>(within) + 0.5F) / static_cast<float>(1 << shift);
  }
  return place;
}

PageCorners make_page_corners(std::span<const Vec3i> positions, int bits, int depth) {
  BURNISH_CHECK(positions.size() <= kPageVerticesMax, "not the vertices of a page");
  PageCorners corners{corners_of(cells_of(positions, bits, depth)), {}};
  corners.of_vertex.resize(positions.size());
  for (size_t v = 0; v < positions.size(); ++v) {
    const Vec3i cell = cell_place(positions[v], bits, depth).cell;
    for (int a = 0; a < kCornersPerCell; ++a) {
      const auto at = std::ranges::lower_bound(corners.places, morton_key(cell + corner_offset(a)));
      corners.of_vertex[v][a] = static_cast<uint16_t>(at - corners.places.begin());
    }
  }
  return corners;
}

uint32_t count_page_corners(std::span<const Vec3i> positions, int bits, int depth) {
  return static_cast<uint32_t>(corners_of(cells_of(positions, bits, depth)).size());
}

void evaluate_page(const PageCorners& corners, std::span<const Vec3i> positions, int bits,
                   int depth, std::span<const Vec3f> corner_displacements,
                   std::span<Vec3f> displacements) {
  for (size_t v = 0; v < positions.size(); ++v) {
    const auto weights = trilinear_weights(cell_place(positions[v], bits, depth).local);
    Vec3f sum = Vec3f::Zero();
    for (int a = 0; a < kCornersPerCell; ++a)
      sum += weights[a] * corner_displacements[corners.of_vertex[v][a]];
    displacements[v] = sum;
  }
}

}  // namespace burnish

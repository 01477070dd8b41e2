#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/grid/cell_corners.h"
#include "common/grid/morton.h"

namespace burnish {

/// A lattice point's cell at a depth, and its place in that cell.
struct CellPlace {
  Vec3i cell;
  std::array<float, 3> local;  ///< in (0, 1)³, exact
};

/// Needs: a position on a lattice of `bits` (PageGrid), depth <= bits.
CellPlace cell_place(const Vec3i& position, int bits, int depth);

/// The corners of the cells that hold a page's vertices. A client makes them from the page alone:
/// it evaluates a frame of kind corners without the grid.
struct PageCorners {
  std::vector<MortonKey> places;  ///< of corners, strictly rising: the order of values in a frame
  /// Per vertex the corners of its cell, in corner order.
  std::vector<std::array<uint16_t, kCornersPerCell>> of_vertex;
};

/// Needs: at most kPageVerticesMax positions, as for cell_place().
PageCorners make_page_corners(std::span<const Vec3i> positions, int bits, int depth);

/// Returns how many corners make_page_corners() would find.
uint32_t count_page_corners(std::span<const Vec3i> positions, int bits, int depth);

/// Evaluates the displacement of vertices trilinearly. A vertex of two pages gets the same bits in
/// both. Shapes: one corner displacement per corner, one displacement per vertex.
void evaluate_page(const PageCorners& corners, std::span<const Vec3i> positions, int bits,
                   int depth, std::span<const Vec3f> corner_displacements,
                   std::span<Vec3f> displacements);

}  // namespace burnish

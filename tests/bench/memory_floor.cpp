#include "tests/bench/memory_floor.h"

#include "server/solver/cpu/smoothers/cell_inverse.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish {

namespace {

// Bytes of the elements in the loops of server/solver/cpu.
constexpr double kFloat = 4, kDouble = 8, kIndex = 4, kRowStart = 8, kMask = 4;
constexpr double kFloat4 = 16, kDouble3 = 24;  // three columns; in float a spare one as well
constexpr double kLocal = 2, kTileRow = sizeof(RowTiles::Row);
constexpr double kCellCorners = 8 * kIndex;  // corners of a cell, or cells of a corner
constexpr double kLocalPoint = 3 * kFloat;   // a vertex in its cell
constexpr double kFromCell = sizeof(FromCell);
constexpr double kCombined = sizeof(CellMatrix);
constexpr double kInverse = sizeof(cpu::CellInverse);
constexpr double kIntegrals = sizeof(CellIntegrals);

struct Counts {
  explicit Counts(const HierarchyDepth& depth)
      : corners(depth.grid.corner_count()),
        cells(depth.grid.cell_count()),
        entries(static_cast<double>(depth.stencil.column.size())),
        halo(static_cast<double>(depth.stencil.tiles.halo.item.size())),
        restricted(static_cast<double>(depth.to_parent.restriction_corner.size())) {}

  double corners, cells;
  double entries;     ///< entries of the stencil with its padding, without diagonals
  double halo;        ///< of the tiles
  double restricted;  ///< entries of Pᵀ to the coarser depth
};

// Returns the bytes of one pass over a matrix with numbers of `value` bytes.
double rows_bytes(const Counts& at, double value) {
  return at.entries * (value + kLocal) + at.halo * kIndex + at.corners * (kTileRow + value);
}

// Returns the bytes of r = f − S x.
double residual_bytes(const Counts& at) {
  return rows_bytes(at, kFloat) + at.corners * (kFloat + 3 * kFloat4);
}

// Returns the bytes of x = length·M⁻¹ r + kept·x: `vectors` are read or written.
double relax_bytes(const Counts& at, int vectors) {
  return rows_bytes(at, kFloat) + at.corners * vectors * kFloat4;
}

double vcycle_bytes(const Counts& fine, const Counts& coarse) {
  const double before = relax_bytes(fine, 2) + residual_bytes(fine) + relax_bytes(fine, 3);
  const double after =
      2 * (residual_bytes(fine) + relax_bytes(fine, 3)) + fine.corners * kFloat4;  // r is kept once
  const double restriction = residual_bytes(fine) + fine.corners * kFloat4 +
                             fine.restricted * (kIndex + kFloat) +
                             coarse.corners * (kRowStart + kFloat + kFloat4);
  const double prolongation = fine.corners * (kFloat + kFromCell + 2 * kFloat4) +
                              coarse.corners * kFloat4 + coarse.cells * kCellCorners;
  return before + restriction + prolongation + after;
}

// For the outer iteration: u, r, b and q are in double, p is not.
double outer_bytes(const Counts& at, double vertices) {
  const double load = kDouble3 + kFloat4;
  const double direction_sums = 2 * kFloat4 + kDouble3;
  const double direction = 3 * kFloat4;
  const double product = kFloat + kFloat4 + 2 * kDouble3;  // beyond the rows: p, r, q written
  const double advance = kFloat4 + 5 * kDouble3;
  const double measure = kFloat + kDouble3;
  const double correction =
      vertices * kLocalPoint + at.cells * (kCellCorners + kIndex) + at.corners * kFloat4;
  return rows_bytes(at, kDouble) + correction +
         at.corners * (load + direction_sums + direction + product + advance + measure);
}

// A slider moves b and r by a kept vector.
double slide_bytes(const Counts& at) {
  return at.corners * 5 * kDouble3;
}

// Another α for all cells leaves the constraint unchanged, except at pinned corners.
double pins_bytes(const Counts& at) {
  return at.corners * (kCellCorners + kFloat + 1);
}

double assembly_bytes(const Counts& at, bool exact) {
  const double values = kFloat + (exact ? kDouble : 0);
  return at.cells * kCombined + at.entries * values +
         at.corners * (kCellCorners + kIndex + kRowStart + kMask + values + 2 * kFloat);
}

double schwarz_set_up_bytes(const Counts& at) {
  const double invert = at.cells * (kCellCorners + kInverse) + at.entries * kFloat +
                        at.corners * (kIndex + kRowStart + kMask + kFloat);
  const double gather = at.cells * kInverse + at.entries * kFloat +
                        at.corners * (kIndex + kRowStart + kCellCorners + kMask + kFloat);
  return invert + gather;  // λmax is kept
}

}  // namespace

MemoryFloor memory_floor(const BenchSystem& system) {
  const Hierarchy& hierarchy = *system.hierarchy;
  const Counts finest(hierarchy.at(hierarchy.finest));
  MemoryFloor floor;
  floor.step = outer_bytes(finest, static_cast<double>(system.prepared->vertices.size()));
  floor.rhs = slide_bytes(finest);
  floor.matrix = pins_bytes(finest) + finest.cells * (kIntegrals + 2 * kFloat + kCombined);
  for (int depth = hierarchy.finest; depth > hierarchy.coarsest; --depth) {
    const Counts fine(hierarchy.at(depth)), coarse(hierarchy.at(depth - 1));
    const bool is_finest = depth == hierarchy.finest;
    const double restricted = is_finest ? 0 : kCombined;  // memory of the combined numbers
    floor.step += vcycle_bytes(fine, coarse);
    floor.matrix += assembly_bytes(fine, is_finest) + schwarz_set_up_bytes(fine) +
                    fine.cells * (restricted + kIndex) + coarse.cells * kCombined;
  }
  return floor;
}

}  // namespace burnish

#include "tests/bench/memory_floor.h"

#include "server/solver/cell_matrix.h"
#include "server/solver/cpu/cell_inverse.h"

namespace burnish {

namespace {

// The elements that the loops of server/solver/cpu read and write.
constexpr double kFloat = 4, kDouble = 8, kIndex = 4, kRowStart = 8, kMask = 4;
constexpr double kFloat4 = 16, kDouble4 = 32;  // three columns and one spare
constexpr double kCellCorners = 8 * kIndex;    // of a cell; the cells of a corner likewise
constexpr double kFromCell = sizeof(FromCell);
constexpr double kCombined = sizeof(CellMatrix);
constexpr double kInverse = sizeof(cpu::CellInverse);
constexpr double kIntegrals = (28 + 8 + 2 * 28) * kDouble;
constexpr double kGradients = 2 * 21 * kDouble, kConstraint = 3 * 8 * kDouble;
constexpr int kPowerIterations = 2;  // for the largest eigenvalue, after the first matrix

struct Counts {
  explicit Counts(const HierarchyDepth& depth)
      : corners(depth.grid.corner_count()),
        cells(depth.grid.cell_count()),
        entries(static_cast<double>(depth.stencil.column.size())),
        restricted(static_cast<double>(depth.to_parent.restriction_corner.size())) {}

  double corners, cells;
  double entries;     ///< of the stencil with its padding, diagonals apart
  double restricted;  ///< entries of Pᵀ to the coarser depth
};

// A matrix once through, with numbers of `value` bytes.
double rows_bytes(const Counts& at, double value) {
  return at.entries * (value + kIndex) + at.corners * (kIndex + kRowStart + value);
}

// r = f − S x.
double residual_bytes(const Counts& at) {
  return rows_bytes(at, kFloat) + at.corners * (kFloat + 3 * kFloat4);
}

// One step of the Chebyshev iteration: so many vectors are read or written.
double step_bytes(const Counts& at, int vectors) {
  return rows_bytes(at, kFloat) + at.corners * vectors * kFloat4;
}

double vcycle_bytes(const Counts& fine, const Counts& coarse) {
  const double before = step_bytes(fine, 2) + residual_bytes(fine) + step_bytes(fine, 3);
  const double after = 2 * (residual_bytes(fine) + step_bytes(fine, 4));
  const double restriction = residual_bytes(fine) + fine.corners * kFloat4 +
                             fine.restricted * (kIndex + kFloat) +
                             coarse.corners * (kRowStart + kFloat + kFloat4);
  const double prolongation = fine.corners * (kFloat + kFromCell + 2 * kFloat4) +
                              coarse.corners * kFloat4 + coarse.cells * kCellCorners;
  return before + restriction + prolongation + after;
}

// The outer iteration: u, r, b and q are in double, p is not.
double outer_bytes(const Counts& at, double vertices) {
  const double load = kDouble4 + kFloat4;
  const double direction_sums = kFloat4 + 2 * kDouble4;
  const double direction = 3 * kFloat4;
  const double product = kFloat + kFloat4 + 2 * kDouble4;  // besides the rows: p, r, q written
  const double advance = kFloat4 + 5 * kDouble4;
  const double measure = kFloat + 3 * kDouble4;
  const double correction =
      vertices * sizeof(EvaluationPoint) + at.cells * kCellCorners + at.corners * kFloat4;
  return rows_bytes(at, kDouble) + correction +
         at.corners * (load + direction_sums + direction + product + advance + measure);
}

double constraint_bytes(const Counts& at) {
  return at.cells * (3 * kFloat + kGradients + 2 * kConstraint) +
         at.corners * (kCellCorners + kFloat + 4 * kDouble4);  // b and r read and written
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
  const double power = kPowerIterations * (residual_bytes(at) + step_bytes(at, 2)) +
                       at.corners * 7 * kFloat4;  // two dot products, cleared, normalised
  return invert + gather + power;
}

}  // namespace

MemoryFloor memory_floor(const BenchSystem& system) {
  const Hierarchy& hierarchy = *system.hierarchy;
  const Counts finest(hierarchy.at(hierarchy.finest));
  MemoryFloor floor;
  floor.step = outer_bytes(finest, static_cast<double>(system.prepared->vertices.size()));
  floor.rhs = constraint_bytes(finest);
  floor.matrix = floor.rhs + finest.cells * (kIntegrals + 2 * kFloat + kCombined);
  for (int depth = hierarchy.finest; depth > hierarchy.coarsest; --depth) {
    const Counts fine(hierarchy.at(depth)), coarse(hierarchy.at(depth - 1));
    const bool is_finest = depth == hierarchy.finest;
    const double restricted = is_finest ? 0 : kCombined;  // there while they are combined
    floor.step += vcycle_bytes(fine, coarse);
    floor.matrix += assembly_bytes(fine, is_finest) + schwarz_set_up_bytes(fine) +
                    fine.cells * (restricted + kIndex) + coarse.cells * kCombined;
  }
  return floor;
}

}  // namespace burnish

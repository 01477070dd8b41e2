#include "tests/bench/memory_floor.h"

#include "server/solver/cell_matrix.h"

namespace burnish {

namespace {

// The elements that the loops of server/solver/cpu read and write.
constexpr double kFloat = 4, kDouble = 8, kIndex = 4, kRowStart = 8, kMask = 4;
constexpr double kFloat4 = 16, kDouble4 = 32;  // three columns and one spare
constexpr double kCellCorners = 8 * kIndex;    // of a cell; cells of a corner likewise
constexpr double kFromCell = sizeof(DepthTransfer::FromCell);
constexpr double kCellInverse = (28 + 8) * kFloat;
constexpr double kCombined = sizeof(CellMatrix);
constexpr double kIntegrals = (28 + 8 + 2 * 28) * kDouble;
constexpr double kGradients = 2 * 21 * kDouble;
constexpr int kPowerIterations = 4;  // for the largest eigenvalue, after the first matrix

struct Counts {
  explicit Counts(const HierarchyDepth& depth)
      : corners(depth.grid.corner_count()),
        cells(depth.grid.cell_count()),
        entries(static_cast<double>(depth.stencil.entry_count())),
        restricted(static_cast<double>(depth.to_parent.restriction_corner.size())) {}

  double corners, cells;
  double entries;     ///< of the stencil, diagonals apart
  double restricted;  ///< entries of Pᵀ to the coarser depth
};

double row_bytes(const Counts& at, double value) {
  return at.entries * (value + kIndex) + at.corners * (kRowStart + value);
}

// r = f − S x.
double residual_bytes(const Counts& at) {
  return row_bytes(at, kFloat) + at.corners * (kFloat + 3 * kFloat4);
}

// d = momentum·d + length·M⁻¹ r; x += d.
double schwarz_bytes(const Counts& at, bool from_zero, bool with_momentum) {
  const int vectors = 3 + !from_zero + with_momentum;  // r, d and x written, x and d read
  return row_bytes(at, kFloat) + at.corners * vectors * kFloat4;
}

double vcycle_bytes(const Counts& fine, const Counts& coarse) {
  const double before =
      schwarz_bytes(fine, true, false) + residual_bytes(fine) + schwarz_bytes(fine, false, true);
  const double after = 2 * residual_bytes(fine) + schwarz_bytes(fine, false, false) +
                       schwarz_bytes(fine, false, true);
  const double restriction = residual_bytes(fine) + fine.corners * kFloat4 +
                             fine.restricted * (kIndex + kFloat) +
                             coarse.corners * (kRowStart + kFloat + kFloat4);
  const double prolongation = fine.corners * (kFloat + kFromCell + 2 * kFloat4) +
                              coarse.corners * kFloat4 + coarse.cells * kCellCorners;
  return before + restriction + prolongation + after;
}

// The outer iteration, in double.
double outer_bytes(const Counts& at, double vertices) {
  const double load = kDouble4 + kFloat4;
  const double scalars = kFloat4 + 2 * kDouble4;
  const double direction = kFloat4 + 2 * kDouble4;
  const double product = kFloat + 3 * kDouble4;  // besides the rows: p, r, and q written
  const double advance = 6 * kDouble4;           // u and r read and written, p, q
  const double measure = kFloat + 3 * kDouble4;
  const double correction =
      vertices * sizeof(EvaluationPoint) + at.cells * kCellCorners + at.corners * kFloat4;
  return row_bytes(at, kDouble) + correction +
         at.corners * (load + scalars + direction + product + advance + measure);
}

double constraint_bytes(const Counts& at) {
  return at.corners * (kCellCorners + kFloat + kDouble4) + at.cells * (3 * kFloat + kGradients);
}

double assembly_bytes(const Counts& at, bool exact) {
  const double values = kFloat + (exact ? kDouble : 0);
  return at.cells * kCombined + at.entries * values +
         at.corners * (kCellCorners + kRowStart + kMask + values + 2 * kFloat);
}

double schwarz_set_up_bytes(const Counts& at) {
  const double invert = at.cells * (kCellCorners + kCellInverse) + at.entries * kFloat +
                        at.corners * (kRowStart + kMask + 3 * kFloat);
  const double gather = at.cells * kCellInverse + row_bytes(at, kFloat) +
                        at.corners * (kCellCorners + kMask + kFloat);
  const double iteration = residual_bytes(at) + schwarz_bytes(at, true, false) +
                           at.corners * 6 * kFloat4;  // two dot products, normalised in place
  return invert + gather + kPowerIterations * iteration;
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
    floor.step += vcycle_bytes(fine, coarse);
    floor.matrix += assembly_bytes(fine, depth == hierarchy.finest) + schwarz_set_up_bytes(fine) +
                    fine.cells * (kCombined + kIndex) + coarse.cells * kCombined;
  }
  return floor;
}

}  // namespace burnish

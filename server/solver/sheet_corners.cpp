#include "server/solver/sheet_corners.h"

#include "common/grid/stencil_slots.h"
#include "server/solver/cell_matrix.h"

namespace burnish {

namespace {

using EightCells = std::array<int32_t, kCornersPerCell>;

/// Which of the cells around a corner are of which sheet: the least of its cells' sides, -1 where
/// there is no cell.
using SheetOfSide = std::array<int8_t, kCornersPerCell>;

SheetOfSide sheets_around(const EightCells& cells, std::span<const uint32_t> passages) {
  SheetOfSide sheet;
  for (int a = 0; a < kCornersPerCell; ++a)
    sheet[a] = static_cast<int8_t>(cells[a] == kNone ? -1 : a);
  for (int a = 0; a < kCornersPerCell; ++a)
    for (int b = 0; b < a; ++b) {
      if (cells[a] == kNone || cells[b] == kNone || sheet[a] == sheet[b]) continue;
      // Cell a lies on the corner's side away from its local corner a.
      if ((passages[cells[a]] >> slot_between(b, a) & 1) == 0) continue;
      const int8_t kept = std::min(sheet[a], sheet[b]), gone = std::max(sheet[a], sheet[b]);
      for (int8_t& s : sheet)
        if (s == gone) s = kept;
    }
  return sheet;
}

bool are_several(const SheetOfSide& sheet) {
  int first = -1;
  for (int s : sheet) {
    if (s < 0) continue;
    if (first >= 0 && s != first) return true;
    first = s;
  }
  return false;
}

// The diagonal of ℓ¹ + ℓ² at a cell's corner.
double energy_of(const CellIntegrals& cell, int a) {
  double energy = 0;
  for (int b = 0; b < kCornersPerCell; ++b)
    if (b != a) energy -= cell.stiffness[0][pair_index(a, b)] + cell.stiffness[1][pair_index(a, b)];
  return energy;
}

// Numbers the sheets of a shared corner and weighs them.
void add_shared(int32_t corner, const EightCells& cells, const SheetOfSide& sheet,
                std::span<const CellIntegrals> integrals, SheetCorners& found) {
  std::array<double, kCornersPerCell> energy = {};
  double total = 0;
  int sheets = 0;
  for (int a = 0; a < kCornersPerCell; ++a) {
    if (cells[a] == kNone) continue;
    energy[sheet[a]] += energy_of(integrals[cells[a]], a);
    total += energy_of(integrals[cells[a]], a);
    sheets += sheet[a] == a;
  }
  std::array<int32_t, kCornersPerCell> number;
  bool is_first = true;
  for (int s = 0; s < kCornersPerCell; ++s) {
    if (cells[s] == kNone || sheet[s] != s) continue;
    number[s] = is_first ? corner : found.count++;
    is_first = false;
    found.sheet.push_back(number[s]);
    found.weight.push_back(static_cast<float>(total > 0 ? energy[s] / total : 1.0 / sheets));
  }
  for (int a = 0; a < kCornersPerCell; ++a)
    if (cells[a] != kNone) found.of_cell[cells[a]][a] = number[sheet[a]];
  found.shared.push_back(corner);
  found.start.push_back(static_cast<int32_t>(found.sheet.size()));
}

}  // namespace

SheetCorners find_sheet_corners(const PreparedMesh& prepared, const SparseGrid& finest) {
  SheetCorners found;
  found.count = finest.corner_count();
  found.of_cell = finest.cell_corners;
  found.start = {0};
  std::vector<char> is_shared(finest.corners.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < is_shared.size(); ++i)
    is_shared[i] = are_several(sheets_around(finest.cells_of_corner[i], prepared.passages));
  for (int32_t i = 0; i < finest.corner_count(); ++i) {
    if (!is_shared[i]) continue;
    const EightCells& cells = finest.cells_of_corner[i];
    add_shared(i, cells, sheets_around(cells, prepared.passages), prepared.integrals, found);
  }
  return found;
}

}  // namespace burnish

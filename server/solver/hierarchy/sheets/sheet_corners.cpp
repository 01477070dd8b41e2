#include "server/solver/hierarchy/sheets/sheet_corners.h"

#include <algorithm>
#include <numeric>

#include "common/base/resize_touched.h"
#include "common/base/select_numbers.h"
#include "common/grid/stencil_slots.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish {

namespace {

/// A sheet that has a corner as its local corner `side`, and the sheet's copy of the corner.
struct SheetAtCorner {
  int side;
  int32_t sheet;
  int copy;
};

/// The cells at most two away from a corner, 4×4×4 of them, and which of their sheets were reached.
struct Vicinity {
  static constexpr int kSide = 4;
  Vec3i least;
  std::array<uint8_t, kSide* kSide* kSide> reached = {};  // a bit for each sheet of a cell

  static bool holds(const Vec3i& at) {
    return (at.array() >= 0).all() && (at.array() < kSide).all();
  }
  uint8_t& reached_at(const Vec3i& at) {
    return reached[at.x() + kSide * (at.y() + kSide * at.z())];
  }
};

/// All sheets around a corner.
struct Around {
  std::array<SheetAtCorner, kCornersPerCell * kSheetsPerCellMax> sheets;
  int count = 0;
  int copies = 0;

  auto begin() { return sheets.begin(); }
  auto end() { return sheets.begin() + count; }
  auto begin() const { return sheets.begin(); }
  auto end() const { return sheets.begin() + count; }
};

class SheetFinder {
 public:
  SheetFinder(const PreparedMesh& prepared, const SparseGrid& finest)
      : prepared_(prepared), finest_(finest) {
    list_sheets();
  }

  SheetCorners take() {
    const int32_t corners = finest_.corner_count();
    std::vector<uint8_t> copies(corners);
#pragma omp parallel for schedule(static)
    for (int32_t i = 0; i < corners; ++i) copies[i] = static_cast<uint8_t>(sheets_around(i).copies);
    found_.shared = select_numbers(corners, [&](int32_t i) { return copies[i] > 1; });
    found_.start = {0};
    for (const int32_t corner : found_.shared)
      found_.start.push_back(found_.start.back() + copies[corner]);
    const auto shared = static_cast<int32_t>(found_.shared.size());
    found_.copy_count = corners + found_.start.back() - shared;
    found_.copy.resize(found_.start.back());
    found_.weight.resize(found_.start.back());
#pragma omp parallel for schedule(dynamic, 256)
    for (int32_t i = 0; i < shared; ++i) number_copies(i);
    return std::move(found_);
  }

 private:
  void list_sheets() {
    count_sheets();
    const int32_t sheets = found_.first_of_cell.back();
    resize_touched(found_.source, sheets);
    resize_touched(found_.cell, sheets);
    resize_touched(found_.corners, sheets);
#pragma omp parallel for schedule(static)
    for (int32_t c = 0; c < finest_.cell_count(); ++c)
      for (int32_t s = found_.first_of_cell[c]; s < found_.first_of_cell[c + 1]; ++s) {
        found_.source[s] = c;
        found_.cell[s] = finest_.cells[c];
        found_.corners[s] = finest_.cell_corners[c];
      }
    int32_t before = kNone, sheet = 0;
    for (size_t i = 0; i < prepared_.sheets.size(); ++i) {
      const int32_t cell = prepared_.sheets[i].cell;
      sheet = cell == before ? sheet + 1 : found_.first_of_cell[cell];
      found_.source[sheet] = finest_.cell_count() + static_cast<int32_t>(i);
      before = cell;
    }
  }

  void count_sheets() {
    std::vector<int32_t>& first = found_.first_of_cell;
    resize_touched(first, finest_.cells.size() + 1);
    for (const CellSheet& sheet : prepared_.sheets) ++first[sheet.cell + 1];
    for (size_t c = 1; c < first.size(); ++c) first[c] = first[c - 1] + std::max(first[c], 1);
  }

  const CellSheet* of_several(int32_t sheet) const {
    const int32_t i = found_.source[sheet] - finest_.cell_count();
    return i < 0 ? nullptr : &prepared_.sheets[i];
  }
  uint32_t passages(int32_t sheet) const {
    const CellSheet* one = of_several(sheet);
    return one != nullptr ? one->passages : prepared_.passages[found_.source[sheet]];
  }
  const CellIntegrals& integrals(int32_t sheet) const {
    const int32_t i = found_.source[sheet] - finest_.cell_count();
    return i < 0 ? prepared_.integrals[found_.source[sheet]] : prepared_.sheet_integrals[i];
  }

  // Returns whether a sheet has a passage at this slot to the other sheet.
  bool pass_to(int32_t sheet, int32_t other, int slot) const {
    const CellSheet *one = of_several(sheet), *two = of_several(other);
    if (one != nullptr && two != nullptr && one->component != two->component) return false;
    return (passages(sheet) >> slot & 1) != 0;
  }

  // A sheet's cell lies on the corner's side away from its own corner `side`.
  bool hang_together(const SheetAtCorner& a, const SheetAtCorner& b) const {
    return a.side != b.side && pass_to(a.sheet, b.sheet, slot_between(b.side, a.side)) &&
           pass_to(b.sheet, a.sheet, slot_between(a.side, b.side));
  }

  Around sheets_around(int32_t corner) const {
    Around around;
    for (int side = 0; side < kCornersPerCell; ++side) {
      const int32_t cell = finest_.cells_of_corner[corner][side];
      if (cell == kNone) continue;
      for (int32_t s = found_.first_of_cell[cell]; s < found_.first_of_cell[cell + 1];
           ++s, ++around.count)
        around.sheets[around.count] = {side, s, around.count};
    }
    around.copies = around.count;
    for (const SheetAtCorner& a : around) {
      if (around.copies == 1) break;
      for (const SheetAtCorner& b : around)
        if (a.copy != b.copy && hang_together(a, b)) join(a.copy, b.copy, around);
    }
    for (int i = 1; i < around.count && around.copies > 1; ++i)
      if (around.sheets[i].copy == i) join_what_is_near(corner, around.sheets[i], around);
    return around;
  }

  // Joins sheets that hang together by cells nearby: the surface only bends around the corner
  // there.
  void join_what_is_near(int32_t corner, const SheetAtCorner& from, Around& around) const {
    Vicinity near = {morton_point(finest_.corners[corner].place) - Vec3i::Constant(2)};
    struct Reached {
      Vec3i at;
      int32_t sheet;
    };
    std::vector<Reached> open;
    const auto reach = [&](const Vec3i& at, int32_t cell, int32_t sheet) {
      const auto bit = static_cast<uint8_t>(1u << (sheet - found_.first_of_cell[cell]));
      if (near.reached_at(at) & bit) return;
      near.reached_at(at) |= bit;
      open.push_back({at, sheet});
    };
    const auto place_of = [&](int side) { return Vec3i(Vec3i::Constant(2) - corner_offset(side)); };
    const auto cell_at = [&](int side) { return finest_.cells_of_corner[corner][side]; };
    reach(place_of(from.side), cell_at(from.side), from.sheet);
    while (!open.empty()) {
      const Reached here = open.back();
      open.pop_back();
      for (uint32_t left = passages(here.sheet); left != 0; left &= left - 1) {
        const int slot = __builtin_ctz(left);
        const Vec3i at = here.at + Vec3i(slot % 3 - 1, slot / 3 % 3 - 1, slot / 9 - 1);
        if (!Vicinity::holds(at)) continue;
        const int32_t cell = finest_.find_cell(near.least + at);
        if (cell == kNone) continue;
        for (int32_t s = found_.first_of_cell[cell]; s < found_.first_of_cell[cell + 1]; ++s)
          if (pass_to(s, here.sheet, kSlots - 1 - slot)) reach(at, cell, s);
      }
    }
    for (const SheetAtCorner& other : around) {
      const uint8_t reached = near.reached_at(place_of(other.side));
      const int32_t bit = other.sheet - found_.first_of_cell[cell_at(other.side)];
      if ((reached >> bit & 1) != 0 && other.copy != from.copy) join(other.copy, from.copy, around);
    }
  }

  static void join(int a, int b, Around& around) {
    const int kept = std::min(a, b), gone = std::max(a, b);
    for (SheetAtCorner& sheet : around)
      if (sheet.copy == gone) sheet.copy = kept;
    --around.copies;
  }

  // Returns the diagonal of ℓ¹ + ℓ² at a sheet's corner.
  double energy_of(const SheetAtCorner& at) const {
    const CellIntegrals& of = integrals(at.sheet);
    double energy = 0;
    for (int b = 0; b < kCornersPerCell; ++b)
      if (b != at.side)
        energy -= of.stiffness[0][pair_index(at.side, b)] + of.stiffness[1][pair_index(at.side, b)];
    return energy;
  }

  // Numbers the copies of a shared corner and weighs them. A copy is known by its first sheet.
  void number_copies(int32_t shared) {
    const int32_t corner = found_.shared[shared];
    const Around around = sheets_around(corner);
    std::array<double, kCornersPerCell* kSheetsPerCellMax> energy = {};
    double total = 0;
    for (const SheetAtCorner& at : around) {
      energy[at.copy] += energy_of(at);
      total += energy_of(at);
    }
    std::array<int32_t, kCornersPerCell * kSheetsPerCellMax> number;
    const int32_t begin = found_.start[shared];
    // Beyond all corners come the further copies of the shared ones, all but one of each.
    const int32_t further = finest_.corner_count() + begin - shared - 1;
    int32_t copy = 0;
    for (int i = 0; i < around.count; ++i) {
      if (around.sheets[i].copy != i) continue;
      number[i] = copy == 0 ? corner : further + copy;
      found_.copy[begin + copy] = number[i];
      found_.weight[begin + copy] =
          static_cast<float>(total > 0 ? energy[i] / total : 1.0 / around.copies);
      ++copy;
    }
    for (const SheetAtCorner& at : around) found_.corners[at.sheet][at.side] = number[at.copy];
  }

  const PreparedMesh& prepared_;
  const SparseGrid& finest_;
  SheetCorners found_;
};

}  // namespace

SheetCorners find_sheet_corners(const PreparedMesh& prepared, const SparseGrid& finest) {
  return SheetFinder(prepared, finest).take();
}

SheetCorners one_sheet_per_cell(const SparseGrid& finest) {
  SheetCorners found;
  found.first_of_cell.resize(finest.cells.size() + 1);
  std::iota(found.first_of_cell.begin(), found.first_of_cell.end(), 0);
  found.cell = finest.cells;
  found.source.assign(found.first_of_cell.begin(), found.first_of_cell.end() - 1);
  found.corners = finest.cell_corners;
  found.copy_count = finest.corner_count();
  found.start = {0};
  return found;
}

}  // namespace burnish

#include "server/prepare/cell_sheets.h"

#include <algorithm>
#include <string>

#include "common/base/sort_once.h"
#include "common/mesh/components.h"

namespace burnish {

namespace {

constexpr size_t kCellsPerSheet = 4;  // in a soup more cells have several

/// A cell with several components, and its pieces.
struct MixedCell {
  int32_t cell;
  std::span<const CellPiece> pieces;
  std::vector<uint32_t> components;  // rising
};

class Components {
 public:
  Components(const Surface& surface)
      : triangles_(surface.triangles),
        roots_(component_roots(surface.triangles, surface.positions.size())) {}

  uint32_t of(const CellPiece& piece) const {
    return static_cast<uint32_t>(roots_[triangles_[piece.triangle][0]]);
  }
  bool are_several(std::span<const CellPiece> pieces) const {
    return std::ranges::any_of(pieces,
                               [&](const CellPiece& p) { return of(p) != of(pieces.front()); });
  }
  std::vector<uint32_t> all_of(std::span<const CellPiece> pieces) const {
    std::vector<uint32_t> all;
    for (const CellPiece& piece : pieces) all.push_back(of(piece));
    sort_once(all);
    return all;
  }

 private:
  std::span<const Triangle> triangles_;
  std::vector<int32_t> roots_;
};

// Cells and pieces are in the same order. Pieces between them may belong to cells that were left
// out.
std::vector<MixedCell> find_mixed_cells(const Components& components,
                                        std::span<const CellPiece> pieces,
                                        std::span<const MortonKey> cells) {
  const std::vector<size_t> starts = cell_starts(pieces);
  const auto pieces_of = [&](size_t group) {
    return pieces.subspan(starts[group], starts[group + 1] - starts[group]);
  };
  std::vector<char> is_mixed(starts.size() - 1);
#pragma omp parallel for schedule(static)
  for (size_t group = 0; group < is_mixed.size(); ++group)
    is_mixed[group] = components.are_several(pieces_of(group));
  std::vector<MixedCell> mixed;
  size_t cell = 0;
  for (size_t group = 0; group < is_mixed.size(); ++group) {
    if (!is_mixed[group]) continue;
    const auto of_cell = pieces_of(group);
    while (cell < cells.size() && cells[cell] < of_cell.front().cell) ++cell;
    if (cell == cells.size()) break;
    if (cells[cell] != of_cell.front().cell) continue;
    mixed.push_back({static_cast<int32_t>(cell), of_cell, components.all_of(of_cell)});
  }
  return mixed;
}

bool are_of_a_soup(const std::vector<MixedCell>& mixed, size_t cells) {
  return mixed.size() > cells / kCellsPerSheet ||
         std::ranges::any_of(mixed, [](const MixedCell& cell) {
           return cell.components.size() > kSheetsPerCellMax;
         });
}

}  // namespace

Result<CellSheets> find_cell_sheets(const Surface& surface, std::span<const CellPiece> pieces,
                                    std::span<const MortonKey> cells,
                                    std::span<const Passages> passages,
                                    const std::function<Status(size_t sheets)>& admit) {
  CellSheets found;
  const Components components(surface);
  const std::vector<MixedCell> mixed = find_mixed_cells(components, pieces, cells);
  if (are_of_a_soup(mixed, cells.size())) return found;
  size_t sheets = 0;
  for (const MixedCell& cell : mixed) sheets += cell.components.size();
  RETURN_IF_ERROR(admit(sheets));
  std::vector<const MixedCell*> cell_of_sheet;
  cell_of_sheet.reserve(sheets);
  found.sheets.reserve(sheets);
  for (const MixedCell& cell : mixed)
    for (uint32_t component : cell.components) {
      found.sheets.push_back({cell.cell, component, 0});
      cell_of_sheet.push_back(&cell);
    }
  found.integrals.resize(found.sheets.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (size_t s = 0; s < found.sheets.size(); ++s) {
    CellSheet& sheet = found.sheets[s];
    CellIntegrator integrator;
    for (const CellPiece& piece : cell_of_sheet[s]->pieces) {
      if (components.of(piece) != sheet.component) continue;
      surface.integrate(piece, integrator);
      sheet.passages |= piece.passages;
    }
    sheet.passages &= passages[sheet.cell];
    found.integrals[s] = integrator.integrals();
  }
  return found;
}

}  // namespace burnish

#include "server/prepare/cell_sheets.h"

#include <algorithm>
#include <vector>

#include "common/base/parallel.h"
#include "common/mesh/statistics/components.h"

namespace burnish {

namespace {

constexpr size_t kCellsPerSheet = 4;    // in a soup more cells have several
constexpr size_t kLargeCell = 1 << 14;  // pieces; integrating them takes some milliseconds

/// The components of the mesh, each by its least vertex.
class Components {
 public:
  Components(const GridMesh& mesh, const ScratchSpace& space, const LoopPart& part)
      : triangles_(mesh.triangles), roots_(space, mesh.positions.size()) {
    find_component_roots(triangles_, {roots_.data(), roots_.size()}, part);
  }

  uint32_t of(const CellPiece& piece) const {
    return static_cast<uint32_t>(roots_[triangles_[piece.triangle][0]]);
  }
  bool are_several(std::span<const CellPiece> pieces) const {
    return std::ranges::any_of(pieces,
                               [&](const CellPiece& p) { return of(p) != of(pieces.front()); });
  }
  /// Returns the components, rising; some of them if there are more than kSheetsPerCellMax.
  std::vector<uint32_t> all_of(std::span<const CellPiece> pieces) const {
    std::vector<uint32_t> all;
    for (const CellPiece& piece : pieces) {
      const auto at = std::ranges::lower_bound(all, of(piece));
      if (at != all.end() && *at == of(piece)) continue;
      all.insert(at, of(piece));
      if (all.size() > kSheetsPerCellMax) break;
    }
    return all;
  }

 private:
  std::span<const Triangle> triangles_;
  ScratchArray<int32_t> roots_;
};

/// A cell through which several components pass.
struct MixedCell {
  int32_t cell;
  std::span<const CellPiece> pieces;
};

/// Finds the pieces of mixed cells by all threads. Shapes: a list for each chunk of the pieces.
std::vector<std::vector<std::span<const CellPiece>>> find_mixed_pieces(
    const Components& components, std::span<const CellPiece> pieces, const LoopPart& part) {
  LoopProgress loop(part.progress, part.phase, part.begin, part.begin);
  const std::vector<size_t> starts = chunks_of_cells(pieces);
  std::vector<std::vector<std::span<const CellPiece>>> found(starts.size() - 1);
  ParallelFailure failure;
  ask_before(loop);
#pragma omp parallel for schedule(dynamic)
  for (size_t chunk = 0; chunk < found.size(); ++chunk)
    failure.run([&] {
      for (size_t begin = starts[chunk], end; begin < starts[chunk + 1]; begin = end) {
        if (!loop.goes_on(0)) return;
        end = end_of_cell(pieces, begin);
        const auto of_cell = pieces.subspan(begin, end - begin);
        if (components.are_several(of_cell)) found[chunk].push_back(of_cell);
      }
    });
  failure.rethrow();
  leave_if_cancelled(loop);
  return found;
}

// Leaves out pieces of cells that were left out.
std::vector<MixedCell> find_mixed_cells(const Components& components,
                                        std::span<const CellPiece> pieces,
                                        std::span<const MortonKey> cells, const LoopPart& part) {
  std::vector<MixedCell> mixed;
  for (const auto& chunk : find_mixed_pieces(components, pieces, part))
    for (const std::span<const CellPiece> of_cell : chunk) {
      const auto at = std::ranges::lower_bound(cells, of_cell.front().cell);
      if (at != cells.end() && *at == of_cell.front().cell)
        mixed.push_back({static_cast<int32_t>(at - cells.begin()), of_cell});
    }
  return mixed;
}

// Returns how many sheets the cells have; none for a soup.
size_t count_sheets(const Components& components, const std::vector<MixedCell>& mixed, size_t cells,
                    const LoopPart& part) {
  if (mixed.size() > cells / kCellsPerSheet) return 0;
  LoopProgress loop(part.progress, part.phase, part.begin, part.begin);
  size_t sheets = 0;
  for (const MixedCell& cell : mixed) {
    if (!loop.goes_on(0)) leave_cancelled_work();
    const size_t of_cell = components.all_of(cell.pieces).size();
    if (of_cell > kSheetsPerCellMax) return 0;
    sheets += of_cell;
  }
  return sheets;
}

CellIntegrals integrate_sheet(const Surface& surface, const Components& components,
                              std::span<const CellPiece> pieces, CellSheet& sheet,
                              LoopProgress& loop) {
  CellIntegrator integrator;
  for (size_t i = 0; i < pieces.size(); ++i) {
    const CellPiece& piece = pieces[i];
    if (i % kHeardBlock == 0 && !loop.goes_on(0)) break;
    if (components.of(piece) != sheet.component) continue;
    surface.integrate(piece, surface.curvature.of(piece.triangle), integrator);
    sheet.passages |= piece.passages;
  }
  return integrator.integrals();
}

// The calling thread takes the sheets of large cells, because it alone hears a cancel.
void integrate_sheets(const Surface& surface, const Components& components,
                      std::span<const MixedCell* const> cell_of_sheet, const LoopPart& part,
                      CellSheets& found) {
  LoopProgress loop(part.progress, part.phase, part.begin, part.begin);
  const auto integrate = [&](size_t s) {
    found.integrals[s] =
        integrate_sheet(surface, components, cell_of_sheet[s]->pieces, found.sheets[s], loop);
  };
  const auto is_large = [&](size_t s) { return cell_of_sheet[s]->pieces.size() > kLargeCell; };
  ask_before(loop);
#pragma omp parallel for schedule(dynamic, 64)
  for (size_t s = 0; s < cell_of_sheet.size(); ++s)
    if (!is_large(s)) integrate(s);
  for (size_t s = 0; s < cell_of_sheet.size(); ++s)
    if (is_large(s)) integrate(s);
  leave_if_cancelled(loop);
}

}  // namespace

Result<CellSheets> find_cell_sheets(const Surface& surface, std::span<const CellPiece> pieces,
                                    std::span<const MortonKey> cells,
                                    std::span<const Passages> passages, const ScratchSpace& space,
                                    const std::function<Status(size_t sheets)>& admit,
                                    const LoopPart& part) {
  CellSheets found;
  const Components components(surface.mesh, space, part.of(0, 0.4));
  const std::vector<MixedCell> mixed = find_mixed_cells(components, pieces, cells, part.of(0.4, 1));
  const size_t sheets = count_sheets(components, mixed, cells.size(), part.of(0.4, 1));
  if (sheets == 0) return found;
  RETURN_IF_ERROR(admit(sheets));
  found.sheets = ScratchArray<CellSheet>(space, sheets);
  found.integrals = ScratchArray<CellIntegrals>(space, sheets);
  std::vector<const MixedCell*> cell_of_sheet;
  cell_of_sheet.reserve(sheets);
  for (const MixedCell& cell : mixed)
    for (const uint32_t component : components.all_of(cell.pieces)) {
      found.sheets[cell_of_sheet.size()] = {cell.cell, component, 0};
      cell_of_sheet.push_back(&cell);
    }
  integrate_sheets(surface, components, cell_of_sheet, part.of(0.4, 1), found);
  for (CellSheet& sheet : found.sheets) sheet.passages &= passages[sheet.cell];
  return found;
}

}  // namespace burnish

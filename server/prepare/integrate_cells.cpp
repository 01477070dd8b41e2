#include "server/prepare/integrate_cells.h"

#include <algorithm>
#include <vector>

#include "server/prepare/piece_curvature.h"

namespace burnish {

namespace {

constexpr size_t kPiecesPerBatch = 1 << 17;  // between two checks for a cancel

/// The pieces of some cells.
struct CellBatch {
  std::span<const CellPiece> pieces;
  std::vector<size_t> starts;  // of each cell in `pieces`, and the end

  size_t cells() const { return starts.size() - 1; }
};

void next_batch(std::span<const CellPiece> pieces, size_t begin, CellBatch& batch) {
  batch.starts = {0};
  size_t end = begin;
  do {
    end = end_of_cell(pieces, end);
    batch.starts.push_back(end - begin);
  } while (end < pieces.size() && end - begin < kPiecesPerBatch);
  batch.pieces = pieces.subspan(begin, end - begin);
}

// Integrates over the pieces of one cell; curvature_of(i) is that of piece i's triangle. Returns
// false if the cell has no area left.
template <typename CurvatureOf>
bool integrate_cell(const Surface& surface, std::span<const CellPiece> pieces,
                    const CurvatureOf& curvature_of, CellIntegrals& integrals,
                    CellCurvature& curvature) {
  CellIntegrator integrator;
  double kappa1 = 0, kappa2 = 0;
  for (size_t i = 0; i < pieces.size(); ++i) {
    const TriangleCurvature& of_triangle = curvature_of(i);
    const double area = surface.integrate(pieces[i], of_triangle, integrator);
    kappa1 += area * of_triangle.kappa1;
    kappa2 += area * of_triangle.kappa2;
  }
  if (integrator.area() <= 0) return false;
  const double scale = surface.length_unit / integrator.area();
  integrals = integrator.integrals();
  curvature = {static_cast<float>(kappa1 * scale), static_cast<float>(kappa2 * scale),
               static_cast<float>(integrator.area())};
  return true;
}

Passages passages_of(std::span<const CellPiece> pieces) {
  Passages all = 0;
  for (const CellPiece& piece : pieces) all |= piece.passages;
  return all;
}

/// Fills the arrays batch by batch.
class Integration {
 public:
  Integration(const Surface& surface, uint64_t cells, const ScratchSpace& space)
      : surface_(surface),
        curvature_(surface.curvature),
        arrays_{{space, cells}, {space, cells}, {space, cells}, {space, cells}},
        holds_surface_(space, cells) {}

  void add(const CellBatch& batch) {
    // The triangles of one huge cell are asked one by one: each has one piece there.
    const bool is_one_cell = batch.cells() == 1;
    if (!is_one_cell) curvature_.load(batch.pieces);
#pragma omp parallel for schedule(dynamic, 64)
    for (size_t i = 0; i < batch.cells(); ++i) {
      const size_t begin = batch.starts[i], cell = done_ + i;
      const auto pieces = batch.pieces.subspan(begin, batch.starts[i + 1] - begin);
      const auto loaded = [&](size_t p) -> const TriangleCurvature& {
        return curvature_[begin + p];
      };
      const auto asked = [&](size_t p) { return surface_.curvature.of(pieces[p].triangle); };
      arrays_.cells[cell] = pieces.front().cell;
      arrays_.passages[cell] = passages_of(pieces);
      CellIntegrals& integrals = arrays_.integrals[cell];
      CellCurvature& curvature = arrays_.curvature[cell];
      holds_surface_[cell] = is_one_cell
                                 ? integrate_cell(surface_, pieces, asked, integrals, curvature)
                                 : integrate_cell(surface_, pieces, loaded, integrals, curvature);
    }
    done_ += batch.cells();
  }

  CellArrays take(const ScratchSpace& space) {
    keep();
    close_one_sided_passages(arrays_.cells, {arrays_.passages.data(), arrays_.passages.size()},
                             space);
    return std::move(arrays_);
  }

 private:
  // Keeps the cells that hold surface, in order.
  void keep() {
    if (std::ranges::find(holds_surface_, 0) == holds_surface_.end()) return;
    const std::span<Passages> passages(arrays_.passages.data(), arrays_.passages.size());
    for (size_t c = 0; c < holds_surface_.size(); ++c)
      if (!holds_surface_[c]) doubt_passages_to(c, arrays_.cells, passages);
    size_t kept = 0;
    for (size_t c = 0; c < holds_surface_.size(); ++c) {
      if (!holds_surface_[c]) continue;
      arrays_.cells[kept] = arrays_.cells[c];
      arrays_.integrals[kept] = arrays_.integrals[c];
      arrays_.curvature[kept] = arrays_.curvature[c];
      arrays_.passages[kept] = arrays_.passages[c];
      ++kept;
    }
    arrays_.cells.truncate(kept);
    arrays_.integrals.truncate(kept);
    arrays_.curvature.truncate(kept);
    arrays_.passages.truncate(kept);
  }

  const Surface& surface_;
  PieceCurvature curvature_;
  CellArrays arrays_;
  ScratchArray<uint8_t> holds_surface_;
  size_t done_ = 0;  // cells
};

}  // namespace

Result<CellArrays> integrate_cells(const Surface& surface, std::span<const CellPiece> pieces,
                                   uint64_t cells, const ScratchSpace& space,
                                   const Progress& progress) {
  Integration integration(surface, cells, space);
  CellBatch batch;
  for (size_t begin = 0; begin < pieces.size(); begin += batch.pieces.size()) {
    next_batch(pieces, begin, batch);
    integration.add(batch);
    const size_t end = begin + batch.pieces.size();
    if (!report(progress, "integrals",
                static_cast<double>(end) / static_cast<double>(pieces.size())))
      return cancelled("cancelled while integrating");
  }
  return integration.take(space);
}

}  // namespace burnish

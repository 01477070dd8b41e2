#include "server/prepare/integrate_cells.h"

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "common/base/heard_loop.h"
#include "server/prepare/radix_sort.h"
#include "server/prepare/unset_vector.h"

namespace burnish {

namespace {

constexpr size_t kPiecesPerBatch = 1 << 17;  // between two checks for a cancel
constexpr double kIntegratedPart = 0.9;      // of the phase "integrals"

/// The pieces of some cells.
struct CellBatch {
  std::span<const CellPiece> pieces;
  std::vector<size_t> starts;  // of each cell in `pieces`, and the end

  size_t cells() const { return starts.size() - 1; }
};

/// The curvature of the triangles of some pieces, made once for each triangle. Keeps its memory
/// from one batch to the next.
class PieceCurvature {
 public:
  explicit PieceCurvature(const MeshCurvature& curvature) : curvature_(curvature) {}

  void load(std::span<const CellPiece> pieces);

  /// Returns the curvature of a loaded piece's triangle.
  const TriangleCurvature& operator[](size_t piece) const { return loaded_[place_[piece]]; }

 private:
  struct PieceOfTriangle {
    uint32_t triangle;
    uint32_t piece;
  };

  const MeshCurvature& curvature_;
  UnsetVector<PieceOfTriangle> order_, spare_;
  UnsetVector<uint32_t> place_;      // per piece, in loaded_
  UnsetVector<uint32_t> triangles_;  // rising
  UnsetVector<TriangleCurvature> loaded_;
};

void PieceCurvature::load(std::span<const CellPiece> pieces) {
  order_.resize(pieces.size());
  spare_.resize(pieces.size());
  place_.resize(pieces.size());
  for (uint32_t i = 0; i < pieces.size(); ++i) order_[i] = {pieces[i].triangle, i};
  radix_sort(std::span(order_), std::span(spare_), std::mem_fn(&PieceOfTriangle::triangle));
  triangles_.clear();
  for (const PieceOfTriangle& of : order_) {
    if (triangles_.empty() || triangles_.back() != of.triangle) triangles_.push_back(of.triangle);
    place_[of.piece] = static_cast<uint32_t>(triangles_.size() - 1);
  }
  loaded_.resize(triangles_.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < triangles_.size(); ++i) loaded_[i] = curvature_.of(triangles_[i]);
}

// A huge cell has a batch of its own.
void next_batch(std::span<const CellPiece> pieces, size_t begin, CellBatch& batch) {
  batch.starts = {0};
  size_t end = end_of_cell(pieces, begin);
  for (;;) {
    batch.starts.push_back(end - begin);
    if (end == pieces.size() || end - begin >= kPiecesPerBatch) break;
    const size_t next = end_of_cell(pieces, end);
    if (next - end > kPiecesPerBatch) break;
    end = next;
  }
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

  // `part` of the cells were done before.
  void add(const CellBatch& batch, LoopProgress& loop, double part) {
    if (batch.cells() == 1) {
      add_one_cell(batch, loop, part);
    } else {
      add_cells(batch);
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
  void add_cells(const CellBatch& batch) {
    curvature_.load(batch.pieces);
#pragma omp parallel for schedule(dynamic, 64)
    for (size_t i = 0; i < batch.cells(); ++i)
      add_cell(batch, i, [&](size_t p) -> const TriangleCurvature& {
        return curvature_[batch.starts[i] + p];
      });
  }

  // The triangles of one huge cell are asked one by one: each has one piece there. The calling
  // thread does it, because it alone hears a cancel.
  void add_one_cell(const CellBatch& batch, LoopProgress& loop, double part) {
    add_cell(batch, 0, [&](size_t p) {
      if (p % kHeardBlock == 0 && !loop.goes_on(part)) leave_cancelled_work();
      return surface_.curvature.of(batch.pieces[p].triangle);
    });
  }

  template <typename CurvatureOf>
  void add_cell(const CellBatch& batch, size_t i, const CurvatureOf& curvature_of) {
    const size_t begin = batch.starts[i], cell = done_ + i;
    const auto pieces = batch.pieces.subspan(begin, batch.starts[i + 1] - begin);
    arrays_.cells[cell] = pieces.front().cell;
    arrays_.passages[cell] = passages_of(pieces);
    holds_surface_[cell] = integrate_cell(surface_, pieces, curvature_of, arrays_.integrals[cell],
                                          arrays_.curvature[cell]);
  }

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
  LoopProgress loop(progress, "integrals", 0, kIntegratedPart);
  for (size_t begin = 0; begin < pieces.size(); begin += batch.pieces.size()) {
    const double part = static_cast<double>(begin) / static_cast<double>(pieces.size());
    if (!loop.goes_on(part)) return cancelled("cancelled while integrating");
    next_batch(pieces, begin, batch);
    integration.add(batch, loop, part);
  }
  return integration.take(space);
}

}  // namespace burnish

#include "server/fields/protection.h"

#include <cmath>
#include <limits>

#include "common/grid/sparse_grid.h"
#include "server/fields/cell_index.h"
#include "server/fields/cell_layers.h"
#include "server/fields/lasso.h"

namespace burnish {

static std::vector<int32_t> indices_of(const std::vector<uint8_t>& flags, uint8_t flag) {
  std::vector<int32_t> indices;
  for (size_t c = 0; c < flags.size(); ++c)
    if (flags[c] == flag) indices.push_back(static_cast<int32_t>(c));
  return indices;
}

std::vector<int32_t> Protection::cells() const {
  return indices_of(is_protected_, 1);
}

void Protection::apply(const Protect& change) {
  is_protected_.resize(prepared_.cells.size(), 0);
  if (std::holds_alternative<NoRegion>(change.way)) return clear();
  if (const auto* grown = std::get_if<GrownRegion>(&change.way)) return grow(grown->cells);
  std::vector<uint8_t> cells;
  if (const auto* lasso = std::get_if<LassoRegion>(&change.way)) cells = chosen(*lasso);
  if (const auto* range = std::get_if<CurvatureRegion>(&change.way)) cells = chosen(*range);
  if (const auto* piece = std::get_if<PieceRegion>(&change.way)) cells = chosen(*piece);
  for (size_t c = 0; c < is_protected_.size(); ++c) {
    if (cells.empty()) {
      is_protected_[c] ^= 1;
    } else if (cells[c] != 0) {
      is_protected_[c] = change.release ? 0 : 1;
    }
  }
}

void Protection::apply(const SetCellFields& change) {
  is_protected_.resize(prepared_.cells.size(), 0);
  for (const SetCellFields::Cell& cell : change.cells)
    is_protected_[index_of_cell(prepared_, cell.cell).value()] = cell.beta > 0;
}

// Shrinking is growing of all other cells.
void Protection::grow(int cells) {
  const uint8_t growing = cells > 0 ? 1 : 0;
  const int steps = std::abs(cells);
  const auto layer = layers_from(prepared_, indices_of(is_protected_, growing), steps);
  for (size_t c = 0; c < layer.size(); ++c)
    if (layer[c] <= steps) is_protected_[c] = growing;
}

std::vector<uint8_t> Protection::chosen(const LassoRegion& lasso) const {
  return cells_in_lasso(prepared_, lasso);
}

std::vector<uint8_t> Protection::chosen(const CurvatureRegion& region) const {
  std::vector<uint8_t> cells(prepared_.cells.size(), 0);
  for (size_t c = 0; c < cells.size(); ++c) {
    const CellCurvature& of = prepared_.curvature[c];
    const double kappa = std::abs(of.kappa1) >= std::abs(of.kappa2) ? of.kappa1 : of.kappa2;
    cells[c] = kappa >= region.least && kappa <= region.most;
  }
  return cells;
}

std::vector<uint8_t> Protection::chosen(const PieceRegion& region) const {
  const Vec3d place = prepared_.frame.to_grid(region.point) - Vec3d::Constant(0.5);
  int32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (size_t c = 0; c < prepared_.cells.size(); ++c) {
    const double away = (morton_point(prepared_.cells[c]).cast<double>() - place).squaredNorm();
    if (away >= least) continue;
    least = away;
    nearest = static_cast<int32_t>(c);
  }
  return cells_of_piece(prepared_, nearest);
}

}  // namespace burnish

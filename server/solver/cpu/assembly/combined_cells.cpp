#include "server/solver/cpu/assembly/combined_cells.h"

#include "common/base/dispatch.h"
#include "server/solver/cpu/assembly/cell_shares.h"
#include "server/solver/cpu/assembly/children.h"

namespace burnish::cpu {

namespace {

constexpr int kCellsAlone = 1024;  // for fewer, waking threads takes longer
constexpr int kCellsAtOnce = 256;  // per thread

BURNISH_DISPATCH void combine(const CellIntegrals& of, const CombineWeights& by, CellMatrix& out) {
  for (int p = 0; p < kPairsPerCell; ++p)
    out.pair[p] = by.mass * of.mass[p] +
                  (by.stiffness1 * of.stiffness[0][p] + by.stiffness2 * of.stiffness[1][p]);
  for (int a = 0; a < 8; ++a) out.row_sum[a] = by.mass * of.mass_row_sum[a];
}

CombineWeights weights_of(const Metric& metric, int32_t cell) {
  return combine_weights(metric.alpha1[cell] * metric.scale, metric.alpha2[cell] * metric.scale);
}

void add_line(const LineMass& line, double weight, CellMatrix& out) {
  for (int p = 0; p < kPairsPerCell; ++p) out.pair[p] += weight * line.pair[p];
  for (int a = 0; a < 8; ++a) out.row_sum[a] += weight * line.row_sum[a];
}

void combine_cell(const PreparedMesh& prepared, const Metric& metric, int32_t cell,
                  CellMatrix& out) {
  const CombineWeights by = weights_of(metric, cell);
  combine(prepared.integrals[cell], by, out);
  if (const LineMass* line = metric.held.find(cell)) add_line(*line, held_line_weight(by), out);
}

void combine_sheet(const PreparedMesh& prepared, const Metric& metric, int32_t cell_count,
                   int32_t s, CombinedCells& cells) {
  CellMatrix sheet;
  combine(prepared.sheet_integrals[s], weights_of(metric, prepared.sheets[s].cell), sheet);
  write_square(sheet, cells.numbers() + number_of_tie(cell_count, s, 0, 0));
}

void combine_sheets(const PreparedMesh& prepared, const Metric& metric,
                    const HierarchyDepth& finest, CombinedCells& cells) {
#pragma omp parallel for schedule(static)
  for (int32_t s = 0; s < finest.sheet_count; ++s)
    combine_sheet(prepared, metric, finest.grid.cell_count(), s, cells);
}

// `child_of(cell)` returns the cells of the finer depth.
template <typename ChildOf>
CellMatrix restrict_children_of(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                int32_t parent, ChildOf&& child_of) {
  RestrictedCell sum;
  for (const int32_t child : coarse.children[parent])
    add_restricted(child_of(child), static_cast<int>(fine.grid.cells[child].place & 7), sum);
  return sum.packed();
}

// `child_of(cell)` returns the cells of the finer depth, each once.
template <typename ChildOf>
CombinedCells restrict_children(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                ChildOf&& child_of) {
  CombinedCells cells(coarse);
#pragma omp parallel for schedule(dynamic, kCellsAtOnce)
  for (int32_t parent = 0; parent < coarse.grid.cell_count(); ++parent)
    cells[parent] = restrict_children_of(fine, coarse, parent, child_of);
  return cells;
}

}  // namespace

void combine_cells(const PreparedMesh& prepared, const Metric& metric, CombinedCells& cells) {
#pragma omp parallel for schedule(dynamic, kCellsAtOnce)
  for (size_t c = 0; c < prepared.integrals.size(); ++c)
    combine_cell(prepared, metric, static_cast<int32_t>(c), cells[c]);
}

CombinedCells combine_and_down_sample(const PreparedMesh& prepared, const Metric& metric,
                                      const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                      CombinedCells& fine_cells) {
  CombinedCells cells = restrict_children(fine, coarse, [&](int32_t c) -> const CellMatrix& {
    combine_cell(prepared, metric, c, fine_cells[c]);
    return fine_cells[c];
  });
#pragma omp parallel for schedule(static) if (coarse.shares.apart.size() > kCellsAlone)
  for (const int32_t c : coarse.shares.apart) combine_cell(prepared, metric, c, fine_cells[c]);
  combine_sheets(prepared, metric, fine, fine_cells);
  add_shares(fine, coarse, fine_cells, cells);
  return cells;
}

CombinedCells down_sample(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                          const CombinedCells& fine_cells) {
  CombinedCells cells = restrict_children(
      fine, coarse, [&](int32_t c) -> const CellMatrix& { return fine_cells[c]; });
  add_shares(fine, coarse, fine_cells, cells);
  return cells;
}

void combine_parts(const PreparedMesh& prepared, const Metric& metric, const HierarchyDepth& finest,
                   std::span<const int32_t> parts, CombinedCells& cells) {
  const int32_t cell_count = finest.grid.cell_count();
#pragma omp parallel for schedule(dynamic, kCellsAtOnce) if (parts.size() > kCellsAlone)
  for (const int32_t part : parts) {
    if (part < cell_count)
      combine_cell(prepared, metric, part, cells[part]);
    else
      combine_sheet(prepared, metric, cell_count, part - cell_count, cells);
  }
}

void down_sample_parts(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                       std::span<const int32_t> parts, const CombinedCells& fine_cells,
                       CombinedCells& coarse_cells) {
  const auto child_of = [&](int32_t c) -> const CellMatrix& { return fine_cells[c]; };
#pragma omp parallel for schedule(dynamic, kCellsAtOnce) if (parts.size() > kCellsAlone)
  for (const int32_t part : parts) {
    if (part < coarse.grid.cell_count())
      coarse_cells[part] = restrict_children_of(fine, coarse, part, child_of);
    add_shares(fine, coarse, part, fine_cells, coarse_cells);
  }
}

}  // namespace burnish::cpu

#include "server/solver/cpu/assembly.h"

#include <algorithm>

#include "common/base/dispatch.h"
#include "server/solver/cpu/blocks.h"
#include "server/solver/cpu/gather_rows.h"
#include "server/solver/cpu/restricted_cell.h"
#include "server/solver/cpu/scratch.h"

namespace burnish::cpu {

namespace {

constexpr double kPinnedBelow = 1e-12;  // of the median diagonal
constexpr size_t kMedianSamplesMax = 1 << 12;

BURNISH_DISPATCH void combine(const CellIntegrals& of, const CombineWeights& by, CellMatrix& out) {
  for (int p = 0; p < 28; ++p)
    out.pair[p] = by.mass * of.mass[p] +
                  (by.stiffness1 * of.stiffness[0][p] + by.stiffness2 * of.stiffness[1][p]);
  for (int a = 0; a < 8; ++a) out.row_sum[a] = by.mass * of.mass_row_sum[a];
}

// The cells of a coarse depth; `child_of(cell)` gives those of the finer one, each once.
template <typename ChildOf>
Scratch<CellMatrix> down_sample(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                ChildOf&& child_of) {
  const int32_t parents = coarse.grid.cell_count();
  Scratch<CellMatrix> cells(parents);
#pragma omp parallel for schedule(static)
  for (int32_t parent = 0; parent < parents; ++parent) {
    RestrictedCell sum;
    for (int32_t i = coarse.child_start[parent]; i < coarse.child_start[parent + 1]; ++i) {
      const int32_t child = coarse.child[i];
      add_restricted(child_of(child), static_cast<int>(fine.grid.cells[child].place & 7), sum);
    }
    cells[parent] = sum.packed();
  }
  return cells;
}

// The median of an even sample: exact enough for a threshold twelve decades below it.
double sampled_median(const std::vector<float>& values) {
  const size_t stride = std::max<size_t>(1, values.size() / kMedianSamplesMax);
  std::vector<float> sample;
  for (size_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
  const auto middle = sample.begin() + static_cast<int64_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle;
}

void invert_diagonal(const std::vector<float>& diagonal, std::vector<float>& inverse) {
  const double pinned_below = kPinnedBelow * sampled_median(diagonal);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < diagonal.size(); ++i)
    inverse[i] = diagonal[i] > pinned_below ? 1 / diagonal[i] : 0;
}

struct Outputs {
  float* entry;
  float* diagonal;
  double* exact_entry;  // none at the coarser depths
  double* row_sum;
};

BURNISH_DISPATCH void assemble_rows(const RowSources& sources, const double* cells,
                                    const Outputs& out, int32_t begin, int32_t end) {
  for (int32_t stored = begin; stored < end; ++stored) {
    const GatheredRow<double> row = gather_row(sources, cells, stored);
    const int32_t corner = sources.corner[stored];
    out.diagonal[corner] = static_cast<float>(row.own - row.off_diagonal);
    store_row(sources, stored, row, out.entry);
    if (out.exact_entry == nullptr) continue;
    store_row(sources, stored, row, out.exact_entry);
    out.row_sum[corner] = row.own;
  }
}

void assemble_depth(const Scratch<CellMatrix>& cells, CpuDepth& depth, ExactMatrix* exact) {
  static_assert(sizeof(CellMatrix) == kNumbersPerCell * sizeof(double));
  const RowSources sources(depth.topology);
  Outputs out = {depth.system.entry.data(), depth.system.diagonal.data(), nullptr, nullptr};
  if (exact != nullptr) {
    out.exact_entry = exact->entry.data();
    out.row_sum = exact->row_sum.data();
  }
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    assemble_rows(sources, cells[0].pair.data(), out, begin, end);
  });
  invert_diagonal(depth.system.diagonal, depth.inverse_diagonal);
}

}  // namespace

void assemble(const PreparedMesh& prepared, std::span<const float> alpha1,
              std::span<const float> alpha2, std::span<CpuDepth> depths, ExactMatrix* exact) {
  const double scale = prepared.alpha_scale();
  Scratch<CellMatrix> cells(prepared.integrals.size());
  const auto combined = [&](int32_t c) -> const CellMatrix& {
    combine(prepared.integrals[c], combine_weights(alpha1[c] * scale, alpha2[c] * scale), cells[c]);
    return cells[c];
  };
  const auto of_depth = [&](int32_t c) -> const CellMatrix& { return cells[c]; };
  if (depths.size() == 1)
    for (int32_t c = 0; c < depths[0].topology.grid.cell_count(); ++c) combined(c);
  for (size_t d = depths.size() - 1; d > 0; --d) {
    const HierarchyDepth &fine = depths[d].topology, &coarse = depths[d - 1].topology;
    const bool finest = d + 1 == depths.size();  // combined while they are restricted
    Scratch<CellMatrix> parents =
        finest ? down_sample(fine, coarse, combined) : down_sample(fine, coarse, of_depth);
    assemble_depth(cells, depths[d], finest ? exact : nullptr);
    cells = std::move(parents);
  }
  assemble_depth(cells, depths[0], depths.size() == 1 ? exact : nullptr);
}

}  // namespace burnish::cpu

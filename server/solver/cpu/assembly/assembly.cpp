#include "server/solver/cpu/assembly/assembly.h"

#include <algorithm>

#include "common/base/blocks.h"
#include "common/base/dispatch.h"
#include "server/solver/cpu/assembly/combined_cells.h"
#include "server/solver/cpu/assembly/gather_rows.h"
#include "server/solver/cpu/assembly/irregular_rows.h"

namespace burnish::cpu {

namespace {

constexpr double kPinnedBelow = 1e-12;  // of the median diagonal
constexpr size_t kMedianSamplesMax = 1 << 12;

// Returns the median of an even sample: exact enough for a threshold far below it.
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
    const int32_t corner = sources.corner[stored];
    if (sources.mask[corner] == 0) continue;  // irregular
    const GatheredRow<double> row = gather_row(sources, cells, stored);
    out.diagonal[corner] = static_cast<float>(row.own - row.off_diagonal);
    store_row(sources, stored, row, out.entry);
    if (out.exact_entry == nullptr) continue;
    store_row(sources, stored, row, out.exact_entry);
    out.row_sum[corner] = row.own;
  }
}

void assemble_irregular_rows(const CombinedCells& cells, CpuDepth& depth) {
  const auto store = [&](int32_t corner, int64_t begin, std::span<const double> entries,
                         double row_sum) {
    for (double entry : entries) row_sum -= entry;
    depth.system.diagonal[corner] = static_cast<float>(row_sum);
    for (size_t k = 0; k < entries.size(); ++k)
      depth.system.entry[begin + k] = static_cast<float>(entries[k]);
  };
  sum_irregular_rows(depth.topology.stencil, cells.numbers(), depth.topology.number_count(), store);
}

void assemble_depth(const CombinedCells& cells, CpuDepth& depth, ExactMatrix* exact) {
  const RowSources sources(depth.topology);
  Outputs out = {depth.system.entry.data(), depth.system.diagonal.data(), nullptr, nullptr};
  if (exact != nullptr) {
    out.exact_entry = exact->entry.data();
    out.row_sum = exact->row_sum.data();
  }
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    assemble_rows(sources, cells.numbers(), out, begin, end);
  });
  assemble_irregular_rows(cells, depth);
  invert_diagonal(depth.system.diagonal, depth.inverse_diagonal);
}

}  // namespace

void assemble(const PreparedMesh& prepared, const CellAlphas& alphas, std::span<CpuDepth> depths,
              ExactMatrix* exact) {
  const Metric metric = {alphas.alpha1, alphas.alpha2, prepared.alpha_scale()};
  CombinedCells cells(depths.back().topology);
  if (depths.size() == 1) combine_cells(prepared, metric, cells);
  for (size_t d = depths.size() - 1; d > 0; --d) {
    const HierarchyDepth &fine = depths[d].topology, &coarse = depths[d - 1].topology;
    const bool is_finest = d + 1 == depths.size();
    CombinedCells parents = is_finest
                                ? combine_and_down_sample(prepared, metric, fine, coarse, cells)
                                : down_sample(fine, coarse, cells);
    assemble_depth(cells, depths[d], is_finest ? exact : nullptr);
    cells = std::move(parents);
  }
  assemble_depth(cells, depths[0], depths.size() == 1 ? exact : nullptr);
}

}  // namespace burnish::cpu

#include "server/solver/cpu/assembly/assembly.h"

#include <algorithm>

#include "common/base/blocks.h"
#include "common/base/dispatch.h"
#include "server/solver/cpu/assembly/combined_cells.h"
#include "server/solver/cpu/assembly/gather_rows.h"
#include "server/solver/cpu/assembly/irregular_rows.h"
#include "server/solver/hierarchy/pinned_below.h"

namespace burnish::cpu {

namespace {

constexpr size_t kMedianSamplesMax = 1 << 12;

// Returns the median of an even sample: exact enough for a threshold far below it.
double sampled_median(std::span<const float> values) {
  if (values.empty()) return 0;
  const size_t stride = std::max<size_t>(1, values.size() / kMedianSamplesMax);
  std::vector<float> sample;
  for (size_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
  const auto middle = sample.begin() + static_cast<int64_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle;
}

// A ghost is pinned if its owner pins it.
void invert_diagonal(CpuDepth& depth) {
  const std::vector<float>& diagonal = depth.system.diagonal;
  const HierarchyDepth& topology = depth.topology;
  const double pinned_below =
      kPinnedBelow * sampled_median(std::span(diagonal).first(topology.own_count()));
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < topology.known_count(); ++i)
    depth.inverse_diagonal[i] = diagonal[i] > pinned_below ? 1 / diagonal[i] : 0;
  depth.refresh(depth.inverse_diagonal);
}

struct Outputs {
  float* entry;
  float* diagonal;
  double* exact_entry;  // none at the coarser depths
  double* row_sum;
};

// Makes the inverses again. Adds the corners that became pinned or free.
void invert_diagonal_again(CpuDepth& depth, std::vector<int32_t>& rows) {
  std::vector<float> before = depth.inverse_diagonal;
  invert_diagonal(depth);
  const size_t summed = rows.size();
  for (int32_t i = 0; i < depth.corner_count(); ++i)
    if ((before[i] == 0) != (depth.inverse_diagonal[i] == 0)) rows.push_back(i);
  std::ranges::inplace_merge(rows, rows.begin() + static_cast<int64_t>(summed));
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

// Sums the rows of `sources.only` from `begin` to `end`.
BURNISH_DISPATCH void assemble_rows(const RowSources& sources, const double* cells,
                                    const Outputs& out, int32_t begin, int32_t end) {
  for (int32_t i = begin; i < end; ++i) {
    const int32_t stored = sources.stored(i), corner = sources.corner[stored];
    if (sources.mask[corner] == 0) continue;  // irregular
    const GatheredRow<double> row = gather_row(sources, cells, stored);
    out.diagonal[corner] = static_cast<float>(row.own - row.off_diagonal);
    store_row(sources, stored, row, out.entry);
    if (out.exact_entry == nullptr) continue;
    store_row(sources, stored, row, out.exact_entry);
    out.row_sum[corner] = row.own;
  }
}

auto store_irregular_row(CpuDepth& depth) {
  return [&](int32_t corner, int64_t begin, std::span<const double> entries, double row_sum) {
    for (double entry : entries) row_sum -= entry;
    depth.system.diagonal[corner] = static_cast<float>(row_sum);
    for (size_t k = 0; k < entries.size(); ++k)
      depth.system.entry[begin + k] = static_cast<float>(entries[k]);
  };
}

void assemble_regular_rows(const RowSources& sources, int32_t rows, const CombinedCells& cells,
                           CpuDepth& depth, ExactMatrix* exact) {
  Outputs out = {depth.system.entry.data(), depth.system.diagonal.data(), nullptr, nullptr};
  if (exact != nullptr) {
    out.exact_entry = exact->entry.data();
    out.row_sum = exact->row_sum.data();
  }
  for_each_block(rows, [&](int32_t begin, int32_t end) {
    assemble_rows(sources, cells.numbers(), out, begin, end);
  });
}

void assemble_depth(const CombinedCells& cells, CpuDepth& depth, ExactMatrix* exact) {
  if (!depth.has_rows()) return;
  assemble_regular_rows(RowSources(depth.topology), depth.corner_count(), cells, depth, exact);
  sum_irregular_rows(depth.topology.stencil, cells.numbers(), depth.topology.number_count(),
                     store_irregular_row(depth));
  invert_diagonal(depth);
}

void assemble_rows_again(const CombinedCells& cells, std::vector<int32_t>& rows, CpuDepth& depth,
                         ExactMatrix* exact) {
  if (!depth.has_rows()) return;
  const RowSources sources(depth.topology, rows);
  assemble_regular_rows(sources, static_cast<int32_t>(rows.size()), cells, depth, exact);
  sum_irregular_rows(depth.topology.stencil, rows, cells.numbers(), depth.topology.number_count(),
                     store_irregular_row(depth));
  invert_diagonal_again(depth, rows);
}

void keep_numbers(const CombinedCells& cells, CpuDepth& depth) {
  depth.kept_numbers.assign(cells.numbers(), cells.numbers() + depth.topology.number_count());
}

/// A shard's exchange at the border depth: the first shard has the matrices from there on.
class Border {
 public:
  explicit Border(Halo* halo) : halo_(halo) {}

  void take_numbers(CombinedCells& cells, const CpuDepth& depth) const {
    if (is_at(depth)) halo_->collect(cells.numbers());
  }
  void tell_pins(CpuDepth& depth) const {
    if (is_at(depth)) halo_->refresh(halo_->border(), depth.inverse_diagonal);
  }

 private:
  bool is_at(const CpuDepth& depth) const {
    return halo_ != nullptr && depth.topology.grid.depth == halo_->border();
  }
  Halo* halo_;
};

}  // namespace

size_t depths_not_kept(const Hierarchy& hierarchy, const Halo* halo) {
  if (halo == nullptr) return kDepthsNotKept;
  return std::min(kDepthsNotKept, static_cast<size_t>(hierarchy.finest - halo->border()));
}

void assemble(const PreparedMesh& prepared, const CellMetric& of, std::span<CpuDepth> depths,
              ExactMatrix* exact, size_t not_kept, Halo* halo) {
  const Border border(halo);
  const Metric metric = {of.alphas.alpha1, of.alphas.alpha2, prepared.alpha_scale(), of.held};
  CombinedCells cells(depths.back().topology);
  if (depths.size() == 1) combine_cells(prepared, metric, cells);
  for (size_t d = depths.size() - 1; d > 0; --d) {
    const HierarchyDepth &fine = depths[d].topology, &coarse = depths[d - 1].topology;
    const bool is_finest = d + 1 == depths.size();
    CombinedCells parents = is_finest
                                ? combine_and_down_sample(prepared, metric, fine, coarse, cells)
                                : down_sample(fine, coarse, cells);
    assemble_depth(cells, depths[d], is_finest ? exact : nullptr);
    border.tell_pins(depths[d]);
    cells = std::move(parents);
    border.take_numbers(cells, depths[d - 1]);
    if (depths.size() - (d - 1) > not_kept) keep_numbers(cells, depths[d - 1]);
  }
  assemble_depth(cells, depths[0], depths.size() == 1 ? exact : nullptr);
  border.tell_pins(depths[0]);
}

void assemble_changed(const PreparedMesh& prepared, const CellMetric& of,
                      std::span<ChangedDepth> changed, std::span<CpuDepth> depths,
                      ExactMatrix* exact, Halo* halo) {
  const Border border(halo);
  const Metric metric = {of.alphas.alpha1, of.alphas.alpha2, prepared.alpha_scale(), of.held};
  CombinedCells cells(depths.back().topology);
  combine_parts(prepared, metric, depths.back().topology, changed.back().needed, cells);
  assemble_rows_again(cells, changed.back().rows, depths.back(), exact);
  for (size_t d = depths.size() - 1; d-- > 0;) {
    CpuDepth& depth = depths[d];
    CombinedCells parents(depth.topology);
    std::ranges::copy(depth.kept_numbers, parents.numbers());
    down_sample_parts(depths[d + 1].topology, depth.topology, changed[d].needed, cells, parents);
    border.take_numbers(parents, depth);
    if (!depth.kept_numbers.empty()) keep_numbers(parents, depth);
    assemble_rows_again(parents, changed[d].rows, depth, nullptr);
    border.tell_pins(depth);
    cells = std::move(parents);
  }
}

}  // namespace burnish::cpu

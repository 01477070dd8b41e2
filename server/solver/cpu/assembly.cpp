#include "server/solver/cpu/assembly.h"

#include <algorithm>

namespace burnish::cpu {

static constexpr double kPinnedBelow = 1e-12;  // of the median diagonal
static constexpr size_t kMedianSamplesMax = 1 << 14;

using Square = double[8][8];

static CellMatrix combine(const CellIntegrals& integrals, const CombineWeights& weights) {
  CellMatrix out;
  for (int p = 0; p < 28; ++p)
    out.pair[p] =
        weights.mass * integrals.mass[p] + (weights.stiffness1 * integrals.stiffness[0][p] +
                                            weights.stiffness2 * integrals.stiffness[1][p]);
  for (int a = 0; a < 8; ++a) out.row_sum[a] = weights.mass * integrals.mass_row_sum[a];
  return out;
}

std::vector<CellMatrix> combine_integrals(const PreparedMesh& prepared,
                                          std::span<const float> alpha1,
                                          std::span<const float> alpha2) {
  std::vector<CellMatrix> combined(prepared.cells.size());
  const double scale = prepared.alpha_scale();
  const int64_t cells = static_cast<int64_t>(prepared.cells.size());
#pragma omp parallel for schedule(static)
  for (int64_t c = 0; c < cells; ++c)
    combined[c] =
        combine(prepared.integrals[c], combine_weights(alpha1[c] * scale, alpha2[c] * scale));
  return combined;
}

static void expand(const CellMatrix& cell, Square& full, double (&row_sum)[8]) {
  for (int a = 0; a < 8; ++a) row_sum[a] = full[a][a] = cell.row_sum[a];
  for (int a = 0, p = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b, ++p) {
      full[a][b] = full[b][a] = cell.pair[p];
      full[a][a] -= cell.pair[p];
      full[b][b] -= cell.pair[p];
    }
}

// Pᵀ along one axis for a child on the low or high side of its parent: the child's corner in the
// parent's middle shares itself out by halves.
template <typename Combine>
static void restrict_axis(int axis, bool high, Combine&& combine) {
  const int bit = 1 << axis;
  for (int a = 0; a < 8; ++a)
    if (!(a & bit)) combine(high ? a | bit : a, high ? a : a | bit);  // (kept corner, middle)
}

static void restrict_to_parent(int octant, Square& full, double (&row_sum)[8]) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool high = octant >> axis & 1;
    restrict_axis(axis, high, [&](int kept, int middle) {
      for (int b = 0; b < 8; ++b) {
        full[kept][b] += 0.5 * full[middle][b];
        full[middle][b] *= 0.5;
      }
      row_sum[kept] += 0.5 * row_sum[middle];
      row_sum[middle] *= 0.5;
    });
    for (int a = 0; a < 8; ++a)
      restrict_axis(axis, high, [&](int kept, int middle) {
        full[a][kept] += 0.5 * full[a][middle];
        full[a][middle] *= 0.5;
      });
  }
}

std::vector<CellMatrix> down_sample(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                    std::span<const CellMatrix> fine_cells) {
  const int32_t parents = coarse.grid.cell_count();
  std::vector<CellMatrix> combined(parents);
#pragma omp parallel for schedule(static)
  for (int32_t parent = 0; parent < parents; ++parent) {
    Square sum = {};
    double sum_of_rows[8] = {};
    for (int32_t i = coarse.child_start[parent]; i < coarse.child_start[parent + 1]; ++i) {
      const int32_t child = coarse.child[i];
      Square full;
      double row_sum[8];
      expand(fine_cells[child], full, row_sum);
      restrict_to_parent(static_cast<int>(fine.grid.cells[child].place & 7), full, row_sum);
      for (int a = 0; a < 8; ++a) {
        sum_of_rows[a] += row_sum[a];
        for (int b = 0; b < 8; ++b) sum[a][b] += full[a][b];
      }
    }
    CellMatrix& out = combined[parent];
    for (int a = 0, p = 0; a < 8; ++a) {
      out.row_sum[a] = sum_of_rows[a];
      for (int b = a + 1; b < 8; ++b, ++p) out.pair[p] = sum[a][b];
    }
  }
  return combined;
}

// The median of an even sample: exact enough for a threshold twelve decades below it.
static double sampled_median(const std::vector<float>& values) {
  const size_t stride = std::max<size_t>(1, values.size() / kMedianSamplesMax);
  std::vector<float> sample;
  for (size_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
  const auto middle = sample.begin() + static_cast<int64_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle;
}

static void invert_diagonal(const std::vector<float>& diagonal, std::vector<float>& inverse) {
  const double pinned_below = kPinnedBelow * sampled_median(diagonal);
  for (size_t i = 0; i < diagonal.size(); ++i)
    inverse[i] = diagonal[i] > pinned_below ? 1 / diagonal[i] : 0;
}

void assemble(std::span<const CellMatrix> cells, CpuDepth& depth, ExactMatrix* exact) {
  const Stencil& stencil = depth.topology.stencil;
  const auto pair_of = [&](int32_t cell) -> const auto& {
    return cells[cell].pair;
  };
  const auto own_of = [&](int32_t cell) -> const auto& {
    return cells[cell].row_sum;
  };
  gather_rows(depth.topology, pair_of, own_of,
              [&](int32_t corner, const double* by_slot, double row_sum) {
                double diagonal = row_sum;
                for (int s = 0; s < kSlots; ++s) diagonal -= by_slot[s];
                depth.system.diagonal[corner] = static_cast<float>(diagonal);
                store_row(stencil, corner, by_slot, [&](int64_t k, double value) {
                  depth.system.entry[k] = static_cast<float>(value);
                  if (exact != nullptr) exact->entry[k] = value;
                });
                if (exact != nullptr) exact->row_sum[corner] = row_sum;
              });
  invert_diagonal(depth.system.diagonal, depth.inverse_diagonal);
}

}  // namespace burnish::cpu

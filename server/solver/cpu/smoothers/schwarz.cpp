#include <algorithm>

#include "common/base/blocks.h"
#include "common/base/dispatch.h"
#include "server/solver/cpu/assembly/gather_rows.h"
#include "server/solver/cpu/assembly/irregular_rows.h"
#include "server/solver/cpu/products/products.h"
#include "server/solver/cpu/smoothers/cell_inverse.h"
#include "server/solver/cpu/smoothers/chebyshev.h"
#include "server/solver/cpu/smoothers/smoother.h"
#include "server/solver/cpu/smoothers/spectrum.h"
#include "server/solver/cycle/schwarz_bounds.h"
#include "server/solver/hierarchy/changed_parts.h"

namespace burnish::cpu {

namespace {

constexpr int kDegree = 2;

BURNISH_DISPATCH void sum_rows(const RowSources& sources, const float* cells, float* entry,
                               float* diagonal, int32_t begin, int32_t end) {
  for (int32_t i = begin; i < end; ++i) {
    const int32_t stored = sources.stored(i);
    if (sources.mask[sources.corner[stored]] == 0) continue;  // irregular
    const GatheredRow<float> row = gather_row(sources, cells, stored);
    diagonal[sources.corner[stored]] = row.own;
    store_row(sources, stored, row, entry);
  }
}

void sum_regular_rows(const RowSources& sources, int32_t rows, const Scratch<CellInverse>& cells,
                      StencilMatrix& sum) {
  static_assert(sizeof(CellInverse) == kNumbersPerCell * sizeof(float));
  for_each_block(rows, [&](int32_t begin, int32_t end) {
    sum_rows(sources, cells[0].pair.data(), sum.entry.data(), sum.diagonal.data(), begin, end);
  });
}

auto store_irregular_inverse(StencilMatrix& sum) {
  return [&](int32_t corner, int64_t begin, std::span<const float> entries, float own) {
    std::ranges::copy(entries, sum.entry.begin() + begin);
    sum.diagonal[corner] = own;
  };
}

// Ties have no inverses.
size_t numbers_of_cells(const HierarchyDepth& topology) {
  return kNumbersPerCell * topology.grid.cells.size();
}

void sum_inverses(const HierarchyDepth& topology, const Scratch<CellInverse>& cells,
                  StencilMatrix& sum) {
  sum_regular_rows(RowSources(topology), topology.grid.corner_count(), cells, sum);
  sum_irregular_rows(topology.stencil, cells[0].pair.data(), numbers_of_cells(topology),
                     store_irregular_inverse(sum));
}

void sum_inverses(const HierarchyDepth& topology, std::span<const int32_t> corners,
                  const Scratch<CellInverse>& cells, StencilMatrix& sum) {
  sum_regular_rows(RowSources(topology, corners), static_cast<int32_t>(corners.size()), cells, sum);
  sum_irregular_rows(topology.stencil, corners, cells[0].pair.data(), numbers_of_cells(topology),
                     store_irregular_inverse(sum));
}

class Schwarz final : public DepthSmoother {
 public:
  explicit Schwarz(const HierarchyDepth& topology)
      : inverse_(topology.stencil), lambda_max_(topology.grid.corners.size()) {}

  void set_up(CpuDepth& depth) override {
    sum_inverses(depth.topology, invert_cells(depth, is_careful_), inverse_);
    find_steps(depth);
  }

  // Blocks around the corners change, and with them M⁻¹ at all of the blocks' corners. These rows
  // need the next blocks too.
  void update(CpuDepth& depth, std::span<const int32_t> corners) override {
    const std::vector<int32_t> rows = find_cells_around(depth.topology, corners).corners;
    const CellsAround needed = find_cells_around(depth.topology, rows);
    sum_inverses(depth.topology, rows, invert_cells(depth, is_careful_, needed.cells), inverse_);
    find_steps(depth);
  }

  void be_careful(bool careful) override { is_careful_ = careful; }
  void start_over() override { lambda_max_.start_over(); }

  // After the first step from zero x is d itself.
  void relax_from_zero(CpuDepth& depth) override {
    relax_by(depth, inverse_, depth.f, steps_[0].length, 0);
    depth.refresh(depth.x);
    compute_residual(depth);
    depth.refresh(depth.r);
    relax_by(depth, inverse_, depth.r, steps_[1].length, 1 + steps_[1].momentum);
    depth.refresh(depth.x);
  }

  // The second d is M⁻¹ of the sum of both residuals.
  void relax(CpuDepth& depth) override {
    compute_residual(depth, steps_[0].length);
    depth.refresh(depth.r);
    relax_by(depth, inverse_, depth.r, 1, 1);
    depth.refresh(depth.x);
    compute_residual(depth, steps_[1].length, steps_[1].momentum);
    depth.refresh(depth.r);
    relax_by(depth, inverse_, depth.r, 1, 1);
    depth.refresh(depth.x);
  }

  uint64_t byte_count() const override { return inverse_.byte_count() + lambda_max_.byte_count(); }

 private:
  void find_steps(CpuDepth& depth) {
    const auto apply = [&] {
      depth.refresh(depth.r);
      relax_by(depth, inverse_, depth.r, -1, 0);
      depth.refresh(depth.x);
    };
    const Bounds bounds = {lambda_max_least(depth.anisotropy), kLambdaMaxBound};
    steps_ = chebyshev_steps<kDegree>(lambda_max_.estimate(depth, bounds, apply), kSchwarzRange);
  }

  bool is_careful_ = false;
  StencilMatrix inverse_;  // M⁻¹
  LambdaMax lambda_max_;
  std::array<ChebyshevStep, kDegree> steps_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_schwarz(const HierarchyDepth& topology) {
  return std::make_unique<Schwarz>(topology);
}

}  // namespace burnish::cpu

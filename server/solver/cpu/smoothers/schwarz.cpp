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

namespace burnish::cpu {

namespace {

constexpr int kDegree = 2;

BURNISH_DISPATCH void sum_rows(const RowSources& sources, const float* cells, float* entry,
                               float* diagonal, int32_t begin, int32_t end) {
  for (int32_t stored = begin; stored < end; ++stored) {
    if (sources.mask[sources.corner[stored]] == 0) continue;  // irregular
    const GatheredRow<float> row = gather_row(sources, cells, stored);
    diagonal[sources.corner[stored]] = row.own;
    store_row(sources, stored, row, entry);
  }
}

void sum_inverses(const HierarchyDepth& topology, const Scratch<CellInverse>& cells,
                  StencilMatrix& sum) {
  static_assert(sizeof(CellInverse) == kNumbersPerCell * sizeof(float));
  const RowSources sources(topology);
  for_each_block(topology.grid.corner_count(), [&](int32_t begin, int32_t end) {
    sum_rows(sources, cells[0].pair.data(), sum.entry.data(), sum.diagonal.data(), begin, end);
  });
  const size_t numbers_of_cells = kNumbersPerCell * topology.grid.cells.size();  // ties have none
  sum_irregular_rows(topology.stencil, cells[0].pair.data(), numbers_of_cells,
                     [&](int32_t corner, int64_t begin, std::span<const float> entries, float own) {
                       std::ranges::copy(entries, sum.entry.begin() + begin);
                       sum.diagonal[corner] = own;
                     });
}

class Schwarz final : public DepthSmoother {
 public:
  explicit Schwarz(const HierarchyDepth& topology)
      : inverse_(topology.stencil), lambda_max_(topology.grid.corners.size()) {}

  void set_up(CpuDepth& depth) override {
    sum_inverses(depth.topology, invert_cells(depth), inverse_);
    const auto apply = [&] { relax_by(depth, inverse_, depth.r, -1, 0); };
    const Bounds bounds = {lambda_max_least(depth.anisotropy), kLambdaMaxBound};
    steps_ = chebyshev_steps<kDegree>(lambda_max_.estimate(depth, bounds, apply), kSchwarzRange);
  }

  // After the first step from zero x is d itself.
  void relax_from_zero(CpuDepth& depth) override {
    relax_by(depth, inverse_, depth.f, steps_[0].length, 0);
    compute_residual(depth);
    relax_by(depth, inverse_, depth.r, steps_[1].length, 1 + steps_[1].momentum);
  }

  // The second d is M⁻¹ of the sum of both residuals.
  void relax(CpuDepth& depth) override {
    compute_residual(depth, steps_[0].length);
    relax_by(depth, inverse_, depth.r, 1, 1);
    compute_residual(depth, steps_[1].length, steps_[1].momentum);
    relax_by(depth, inverse_, depth.r, 1, 1);
  }

  uint64_t byte_count() const override { return inverse_.byte_count() + lambda_max_.byte_count(); }

 private:
  StencilMatrix inverse_;  // M⁻¹
  LambdaMax lambda_max_;
  std::array<ChebyshevStep, kDegree> steps_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_schwarz(const HierarchyDepth& topology) {
  return std::make_unique<Schwarz>(topology);
}

}  // namespace burnish::cpu

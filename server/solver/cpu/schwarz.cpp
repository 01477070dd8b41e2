#include "server/solver/cpu/cell_inverse.h"
#include "server/solver/cpu/chebyshev.h"
#include "server/solver/cpu/gather_rows.h"
#include "server/solver/cpu/lambda_max.h"
#include "server/solver/cpu/row_products.h"
#include "server/solver/cpu/smoother.h"
#include "server/solver/schwarz_bounds.h"

namespace burnish::cpu {

namespace {

constexpr int kDegree = 2;

class Schwarz final : public DepthSmoother {
 public:
  explicit Schwarz(const HierarchyDepth& topology)
      : inverse_(topology.stencil),
        direction_(topology.grid.corners.size()),
        lambda_max_(topology.grid.corners.size()) {}

  void set_up(CpuDepth& depth) override {
    const Stencil& stencil = depth.topology.stencil;
    const std::vector<float> scale = diagonal_scale(depth);
    const Scratch<CellInverse> inverses = invert_cells(depth, scale);
    gather_rows<float>(
        depth.topology, [&](int32_t cell, int p) { return inverses[cell].pair[p]; },
        [&](int32_t cell, int a) { return inverses[cell].diagonal[a]; },
        [&](int32_t corner, const float* by_slot, float diagonal) {
          const float here = scale[corner];
          inverse_.diagonal[corner] = diagonal * here * here;
          store_row(stencil, corner, by_slot, [&](int64_t k, float value) {
            inverse_.entry[k] = value * here * scale[stencil.column[k]];
          });
        });
    const auto apply = [&] {
      relax_along(depth, inverse_, {.source = depth.r, .step = {0, -1}, .from_zero = true});
    };
    const Bounds bounds = {lambda_max_least(depth.anisotropy), kLambdaMaxBound};
    steps_ = chebyshev_steps<kDegree>(lambda_max_.estimate(depth, bounds, apply), kSchwarzRange);
  }

  // After the first step from zero x is d itself, and degree two ends with the next.
  void relax_from_zero(CpuDepth& depth) override {
    relax_along(depth, inverse_, {.source = depth.f, .step = steps_[0], .from_zero = true});
    compute_residual(depth);
    relax_along(depth, inverse_, {.source = depth.r, .step = steps_[1], .last_d = &depth.x});
  }

  void relax(CpuDepth& depth) override {
    compute_residual(depth);
    relax_along(depth, inverse_, {.source = depth.r, .step = steps_[0], .d = &direction_});
    compute_residual(depth);
    relax_along(depth, inverse_, {.source = depth.r, .step = steps_[1], .last_d = &direction_});
  }

  uint64_t byte_count() const override {
    return inverse_.byte_count() + bytes_of(direction_) + lambda_max_.byte_count();
  }

 private:
  StencilMatrix inverse_;  // M⁻¹
  std::vector<Float4> direction_;
  LambdaMax lambda_max_;
  std::array<ChebyshevStep, kDegree> steps_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_schwarz(const HierarchyDepth& topology) {
  return std::make_unique<Schwarz>(topology);
}

}  // namespace burnish::cpu

#include <span>

#include "server/solver/cpu/assembly.h"
#include "server/solver/cpu/cell_inverse.h"
#include "server/solver/cpu/chebyshev.h"
#include "server/solver/cpu/lambda_max.h"
#include "server/solver/cpu/smoother.h"

namespace burnish::cpu {

namespace {

constexpr int kDegree = 2;
constexpr float kRange = 20;
// No more than 27 blocks meet (three cells an axis).
constexpr Bounds kLambdaMaxBounds = {10, 27};

class Schwarz final : public DepthSmoother {
 public:
  explicit Schwarz(const HierarchyDepth& topology)
      : inverse_(topology.stencil),
        direction_(topology.grid.corners.size()),
        lambda_max_(topology.grid.corners.size()) {}

  void set_up(CpuDepth& depth) override {
    const Stencil& stencil = depth.topology.stencil;
    const std::vector<float> scale = diagonal_scale(depth);
    const std::vector<CellInverse> inverses = invert_cells(depth, scale);
    const auto pair_of = [&](int32_t cell) -> const auto& {
      return inverses[cell].pair;
    };
    const auto own_of = [&](int32_t cell) -> const auto& {
      return inverses[cell].diagonal;
    };
    gather_rows(depth.topology, pair_of, own_of,
                [&](int32_t corner, const double* by_slot, double diagonal) {
                  const double here = scale[corner];
                  inverse_.diagonal[corner] = static_cast<float>(diagonal * here * here);
                  store_row(stencil, corner, by_slot, [&](int64_t k, double value) {
                    inverse_.entry[k] = static_cast<float>(value * here * scale[stencil.column[k]]);
                  });
                });
    const auto apply = [&] { step<true>(depth, depth.r, {0, -1}); };
    const float lambda_max = lambda_max_.estimate(depth, kLambdaMaxBounds, apply);
    steps_ = chebyshev_steps<kDegree>(lambda_max, kRange);
  }

  void relax_from_zero(CpuDepth& depth) override {
    step<true>(depth, depth.f, steps_[0]);
    relax_by(depth, std::span(steps_).subspan(1));
  }

  void relax(CpuDepth& depth) override { relax_by(depth, steps_); }

  uint64_t byte_count() const override {
    return inverse_.byte_count() + bytes_of(direction_) + lambda_max_.byte_count();
  }

 private:
  void relax_by(CpuDepth& depth, std::span<const ChebyshevStep> steps) {
    for (const ChebyshevStep& now : steps) {
      compute_residual(depth);
      step<false>(depth, depth.r, now);
    }
  }

  // d = momentum·d + length·M⁻¹ source; x += d, or x = d from zero.
  template <bool kFromZero>
  void step(CpuDepth& depth, const std::vector<Float4>& source, ChebyshevStep now) {
    const Stencil& stencil = depth.topology.stencil;
    const int32_t n = depth.corner_count();
#pragma omp parallel for schedule(static)
    for (int32_t corner = 0; corner < n; ++corner) {
      Float4 direction = now.length * product_row(stencil, inverse_, source, corner);
      if (now.momentum != 0) direction += now.momentum * direction_[corner];
      direction_[corner] = direction;
      depth.x[corner] = kFromZero ? direction : Float4(depth.x[corner] + direction);
    }
  }

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

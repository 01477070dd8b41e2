#include <utility>

#include "server/solver/cpu/chebyshev.h"
#include "server/solver/cpu/lambda_max.h"
#include "server/solver/cpu/smoother.h"

namespace burnish::cpu {

namespace {

constexpr int kDegree = 4;
constexpr float kRange = 30;
// The mean eigenvalue of D⁻¹S is 1. A cell's share has none above its eight corners.
constexpr Bounds kLambdaMaxBounds = {1, 8};

class ChebyshevJacobi final : public DepthSmoother {
 public:
  explicit ChebyshevJacobi(const HierarchyDepth& topology)
      : direction_(topology.grid.corners.size()),
        next_(topology.grid.corners.size()),
        lambda_max_(topology.grid.corners.size()) {}

  void set_up(CpuDepth& depth) override {
    const auto apply = [&] {
#pragma omp parallel for schedule(static)
      for (int32_t i = 0; i < depth.corner_count(); ++i)
        depth.x[i] = -depth.inverse_diagonal[i] * depth.r[i];
    };
    steps_ = chebyshev_steps<kDegree>(lambda_max_.estimate(depth, kLambdaMaxBounds, apply), kRange);
  }

  void relax_from_zero(CpuDepth& depth) override {
#pragma omp parallel for schedule(static)
    for (int32_t i = 0; i < depth.corner_count(); ++i)
      depth.x[i] = direction_[i] = steps_[0].length * depth.inverse_diagonal[i] * depth.f[i];
    for (int k = 1; k < kDegree; ++k) step(depth, steps_[k]);
  }

  void relax(CpuDepth& depth) override {
    for (const ChebyshevStep& now : steps_) step(depth, now);
  }

  uint64_t byte_count() const override {
    return bytes_of(direction_) + bytes_of(next_) + lambda_max_.byte_count();
  }

 private:
  // d = momentum·d + length·D⁻¹(f − S x), x += d, in one pass from x to a second vector.
  void step(CpuDepth& depth, ChebyshevStep now) {
    const Stencil& stencil = depth.topology.stencil;
    const int32_t n = depth.corner_count();
#pragma omp parallel for schedule(static)
    for (int32_t i = 0; i < n; ++i) {
      Float4 direction = now.length * depth.inverse_diagonal[i] *
                         (depth.f[i] - product_row(stencil, depth.system, depth.x, i));
      if (now.momentum != 0) direction += now.momentum * direction_[i];
      direction_[i] = direction;
      next_[i] = depth.x[i] + direction;
    }
    std::swap(depth.x, next_);
  }

  std::vector<Float4> direction_;
  std::vector<Float4> next_;
  LambdaMax lambda_max_;
  std::array<ChebyshevStep, kDegree> steps_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_chebyshev_jacobi(const HierarchyDepth& topology) {
  return std::make_unique<ChebyshevJacobi>(topology);
}

}  // namespace burnish::cpu

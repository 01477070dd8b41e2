#include "server/solver/cpu/products/products.h"
#include "server/solver/cpu/smoothers/chebyshev.h"
#include "server/solver/cpu/smoothers/smoother.h"
#include "server/solver/cpu/smoothers/spectrum.h"

namespace burnish::cpu {

namespace {

constexpr int kDegree = 4;
constexpr float kRange = 30;
// The mean eigenvalue of D⁻¹S is 1. No eigenvalue of a cell's share is above 8, its number of
// corners.
constexpr Bounds kLambdaMaxBounds = {1, 8};

class ChebyshevJacobi final : public DepthSmoother {
 public:
  explicit ChebyshevJacobi(const HierarchyDepth& topology)
      : direction_(topology.grid.corners.size()), lambda_max_(topology.grid.corners.size()) {}

  void set_up(CpuDepth& depth) override {
    const auto apply = [&] { relax_along(depth, depth.r, {0, -1}, true); };
    steps_ = chebyshev_steps<kDegree>(lambda_max_.estimate(depth, kLambdaMaxBounds, apply), kRange);
  }

  void relax_from_zero(CpuDepth& depth) override {
    relax_along(depth, depth.f, steps_[0], true);
    for (int k = 1; k < kDegree; ++k) relax_further(depth, steps_[k]);
  }

  void relax(CpuDepth& depth) override {
    for (const ChebyshevStep& now : steps_) relax_further(depth, now);
  }

  void start_over() override { lambda_max_.start_over(); }

  uint64_t byte_count() const override { return bytes_of(direction_) + lambda_max_.byte_count(); }

 private:
  void relax_further(CpuDepth& depth, ChebyshevStep now) {
    compute_residual(depth);
    relax_along(depth, depth.r, now, false);
  }

  // Does d = momentum·d + length·D⁻¹ source; x += d, or x = d from zero.
  void relax_along(CpuDepth& depth, const std::vector<Float4>& source, ChebyshevStep now,
                   bool from_zero) {
#pragma omp parallel for schedule(static)
    for (int32_t i = 0; i < depth.corner_count(); ++i) {
      Float4 direction = now.length * depth.inverse_diagonal[i] * source[i];
      if (now.momentum != 0) direction += now.momentum * direction_[i];
      direction_[i] = direction;
      depth.x[i] = from_zero ? direction : Float4(depth.x[i] + direction);
    }
  }

  std::vector<Float4> direction_;
  LambdaMax lambda_max_;
  std::array<ChebyshevStep, kDegree> steps_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_chebyshev_jacobi(const HierarchyDepth& topology) {
  return std::make_unique<ChebyshevJacobi>(topology);
}

}  // namespace burnish::cpu

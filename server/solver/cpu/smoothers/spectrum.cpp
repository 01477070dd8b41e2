#include "server/solver/cpu/smoothers/spectrum.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "common/base/blocks.h"
#include "server/solver/cpu/products/products.h"
#include "server/solver/cycle/schwarz_bounds.h"

namespace burnish::cpu {

static constexpr int kIterationsFirst = 15;
static constexpr int kIterationsNext = 1;
// Keeps the first iterations within float32, whose range ends at λmax = 19 without it: squares of
// their values are summed. A power of two leaves all bits as they are.
static constexpr int kIterationsPerShrink = 4;
static constexpr float kShrink = 1.0f / (1 << 16);

// Returns x·r.
static double dot(const CpuDepth& depth) {
  auto all = ordered_sum<double>(depth.topology.own_count(), [&](int32_t begin, int32_t end) {
    double sum = 0;
    for (int32_t i = begin; i < end; ++i) sum += (depth.x[i] * depth.r[i]).cast<double>().sum();
    return sum;
  });
  if (depth.halo != nullptr) depth.halo->sum({&all, 1});
  return all;
}

static void set_all(std::vector<Float4>& x, const Float4& value) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < x.size(); ++i) x[i] = value;
}

static void scale_all(std::vector<Float4>& x, float factor) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < x.size(); ++i) x[i] *= factor;
}

// Sets three columns of noise, which leave no eigenvector out.
void LambdaMax::set_start(const std::vector<float>& inverse_diagonal) {
  std::minstd_rand noise(1);
  const auto next = [&] { return static_cast<float>(noise()) / std::minstd_rand::max() - 0.5f; };
  for (size_t i = 0; i < eigenvector_.size(); ++i)
    eigenvector_[i] = std::sqrt(inverse_diagonal[i]) * Float4(next(), next(), next(), 0);
}

float LambdaMax::estimate(CpuDepth& depth, Bounds bounds, const std::function<void()>& apply) {
  if (started_ && !depth.is_spectrum_new) return latest_;
  if (!started_) {
    set_start(depth.inverse_diagonal);
    depth.refresh(eigenvector_);
  }
  const int iterations = started_ ? kIterationsNext : kIterationsFirst;
  started_ = true;
  depth.x.swap(eigenvector_);
  set_all(depth.f, Float4::Zero());
  double before = 0;
  for (int i = 0; i < iterations; ++i) {
    compute_residual(depth);  // −S x
    if (i + 1 == iterations) before = -dot(depth);
    apply();  // x = M⁻¹S x
    if (i % kIterationsPerShrink == 1 && i + 1 < iterations) scale_all(depth.x, kShrink);
  }
  const double after = -dot(depth);
  depth.x.swap(eigenvector_);
  if (!(before > 0 && after > 0 && std::isfinite(after))) {  // all corners are pinned
    started_ = false;
    return static_cast<float>(bounds.most);
  }
  scale_all(eigenvector_, static_cast<float>(1 / std::sqrt(after)));
  latest_ =
      static_cast<float>(std::clamp(after / before * kLambdaMaxMargin, bounds.least, bounds.most));
  return latest_;
}

}  // namespace burnish::cpu

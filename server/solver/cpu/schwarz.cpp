#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "server/solver/cpu/assembly.h"
#include "server/solver/cpu/reduce.h"
#include "server/solver/cpu/smoother.h"

namespace burnish::cpu {

namespace {

constexpr float kRegularisation = 1e-3f;  // on the unit diagonal of the scaled blocks

/// (B_c + reg)⁻¹ of one cell: the pairs and the diagonal.
struct CellInverse {
  std::array<float, 28> pair;
  std::array<float, 8> diagonal;
};

using Block = float[8][8];

void read_scaled_block(const CpuDepth& depth, const std::vector<float>& scale, int32_t cell,
                       Block& block) {
  const auto& corners = depth.topology.grid.cell_corners[cell];
  for (int a = 0; a < 8; ++a) {
    block[a][a] = 1 + kRegularisation;
    for (int b = a + 1; b < 8; ++b) {
      const int64_t k = depth.topology.stencil.position(corners[a], slot_between(a, b));
      block[a][b] = block[b][a] = depth.system.entry[k] * scale[corners[a]] * scale[corners[b]];
    }
  }
}

// Gauss-Jordan without pivoting: the block is symmetric positive definite with a condition number
// of at most 8 / reg.
void invert(Block& m) {
  for (int p = 0; p < 8; ++p) {
    const float inverse_pivot = 1 / m[p][p];
    m[p][p] = 1;
    for (int b = 0; b < 8; ++b) m[p][b] *= inverse_pivot;
    for (int a = 0; a < 8; ++a) {
      if (a == p) continue;
      const float factor = m[a][p];
      m[a][p] = 0;
      for (int b = 0; b < 8; ++b) m[a][b] -= factor * m[p][b];
    }
  }
}

/// The Chebyshev iteration of degree 2 that damps eigenvalues in [λmax/20, λmax].
struct Chebyshev {
  float first_step = 0, momentum = 0, second_step = 0;

  Chebyshev() = default;
  explicit Chebyshev(float lambda_max) {
    const float centre = lambda_max * (1 + 1 / 20.0f) / 2;
    const float half_width = lambda_max * (1 - 1 / 20.0f) / 2;
    const float sigma = centre / half_width;
    const float rho = 1 / (2 * sigma - 1 / sigma);
    first_step = 1 / centre;
    momentum = rho / sigma;
    second_step = 2 * rho / half_width;
  }
};

// An under-estimate of λmax ruins the cycle, an over-estimate by a third costs nothing. No more
// than 27 blocks meet (three cells an axis), which bounds it.
constexpr double kMargin = 1.15;
constexpr double kLambdaMaxLeast = 10;
constexpr double kLambdaMaxBound = 27;
constexpr int kIterationsFirst = 15;
constexpr int kIterationsNext = 4;

class Schwarz final : public DepthSmoother {
 public:
  explicit Schwarz(const HierarchyDepth& topology)
      : inverse_(topology.stencil),
        direction_(topology.grid.corners.size()),
        eigenvector_(topology.grid.corners.size()) {}

  void set_up(CpuDepth& depth) override {
    const Stencil& stencil = depth.topology.stencil;
    const std::vector<float> scale = scale_of(depth);
    const int32_t cells = depth.topology.grid.cell_count();
    std::vector<CellInverse> inverses(cells);
#pragma omp parallel for schedule(static)
    for (int32_t cell = 0; cell < cells; ++cell) inverses[cell] = invert_cell(depth, scale, cell);

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
    if (iterations_ == kIterationsFirst) set_start(scale);
    chebyshev_ = Chebyshev(estimate_lambda_max(depth));
  }

  void relax_from_zero(CpuDepth& depth) override {
    step<true>(depth, depth.f, 0, chebyshev_.first_step);
    compute_residual(depth);
    step<false>(depth, depth.r, chebyshev_.momentum, chebyshev_.second_step);
  }

  void relax(CpuDepth& depth) override {
    compute_residual(depth);
    step<false>(depth, depth.r, 0, chebyshev_.first_step);
    compute_residual(depth);
    step<false>(depth, depth.r, chebyshev_.momentum, chebyshev_.second_step);
  }

  uint64_t byte_count() const override {
    return inverse_.byte_count() + bytes_of(direction_) + bytes_of(eigenvector_);
  }

 private:
  static std::vector<float> scale_of(const CpuDepth& depth) {
    std::vector<float> scale(depth.inverse_diagonal.size());
    for (size_t i = 0; i < scale.size(); ++i) scale[i] = std::sqrt(depth.inverse_diagonal[i]);
    return scale;
  }

  // Three columns of noise that leave no eigenvector out.
  void set_start(const std::vector<float>& scale) {
    std::minstd_rand noise(1);
    const auto next = [&] { return static_cast<float>(noise()) / std::minstd_rand::max() - 0.5f; };
    for (size_t i = 0; i < scale.size(); ++i)
      eigenvector_[i] = scale[i] * Float4(next(), next(), next(), 0);
  }

  static CellInverse invert_cell(const CpuDepth& depth, const std::vector<float>& scale,
                                 int32_t cell) {
    Block block;
    read_scaled_block(depth, scale, cell, block);
    invert(block);
    CellInverse out;
    for (int a = 0, p = 0; a < 8; ++a) {
      out.diagonal[a] = block[a][a];
      for (int b = a + 1; b < 8; ++b, ++p) out.pair[p] = (block[a][b] + block[b][a]) / 2;
    }
    return out;
  }

  // d = momentum·d + length·M⁻¹ source; x += d, or x = d from zero.
  template <bool kFromZero>
  void step(CpuDepth& depth, const std::vector<Float4>& source, float momentum, float length) {
    const Stencil& stencil = depth.topology.stencil;
    const int32_t n = depth.corner_count();
#pragma omp parallel for schedule(static)
    for (int32_t corner = 0; corner < n; ++corner) {
      Float4 direction = length * product_row(stencil, inverse_, source, corner);
      if (momentum != 0) direction += momentum * direction_[corner];
      direction_[corner] = direction;
      depth.x[corner] = kFromZero ? direction : Float4(depth.x[corner] + direction);
    }
  }

  // The largest eigenvalue of M⁻¹S by power iteration, a lower bound that the margin lifts. It
  // starts from the last matrix's eigenvector: between two edits little changes.
  float estimate_lambda_max(CpuDepth& depth) {
    const int iterations = std::exchange(iterations_, kIterationsNext);
    depth.x = eigenvector_;
    std::fill(depth.f.begin(), depth.f.end(), Float4::Zero());
    double lambda = 0;
    for (int i = 0; i < iterations; ++i) {
      compute_residual(depth);  // −S x
      const double before = -dot(depth.x, depth.r);
      step<true>(depth, depth.r, 0, -1);  // x = M⁻¹S x
      const double after = -dot(depth.x, depth.r);
      if (!(before > 0 && after > 0)) break;
      lambda = after / before;
      const float normalise = static_cast<float>(1 / std::sqrt(after));
      for (Float4& x : depth.x) x *= normalise;
    }
    eigenvector_ = depth.x;
    return static_cast<float>(std::clamp(lambda * kMargin, kLambdaMaxLeast, kLambdaMaxBound));
  }

  static double dot(const std::vector<Float4>& x, const std::vector<Float4>& y) {
    return ordered_sum<double>(static_cast<int32_t>(x.size()), [&](int32_t begin, int32_t end) {
      double sum = 0;
      for (int32_t i = begin; i < end; ++i) sum += (x[i] * y[i]).cast<double>().sum();
      return sum;
    });
  }

  StencilMatrix inverse_;  // M⁻¹
  std::vector<Float4> direction_;
  std::vector<Float4> eigenvector_;
  int iterations_ = kIterationsFirst;
  Chebyshev chebyshev_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_schwarz(const HierarchyDepth& topology) {
  return std::make_unique<Schwarz>(topology);
}

}  // namespace burnish::cpu

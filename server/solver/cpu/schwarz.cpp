#include <cmath>

#include "server/solver/cpu/assembly.h"
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
      block[a][b] = block[b][a] =
          depth.system.entry[k] * scale[corners[a]] * scale[corners[b]];
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

class Schwarz final : public DepthSmoother {
 public:
  explicit Schwarz(const HierarchyDepth& topology)
      : inverses_(topology.grid.cells.size()), direction_(topology.grid.corners.size()) {
    inverse_.entry.resize(topology.stencil.column.size());
    inverse_.own.resize(topology.grid.corners.size());
  }

  void set_up(const CpuDepth& depth) override {
    const std::vector<float> scale = scale_of(depth);
    const int32_t cells = depth.topology.grid.cell_count();
#pragma omp parallel for schedule(static)
    for (int32_t cell = 0; cell < cells; ++cell) invert_cell(depth, scale, cell);

    const auto pair_of = [&](int32_t cell) -> const auto& { return inverses_[cell].pair; };
    const auto own_of = [&](int32_t cell) -> const auto& { return inverses_[cell].diagonal; };
    gather_rows(depth.topology, pair_of, own_of,
                [&](int32_t corner, const double* by_slot, double diagonal) {
                  const double here = scale[corner];
                  inverse_.own[corner] = static_cast<float>(diagonal * here * here);
                  store_row(depth.topology.stencil, corner, by_slot, inverse_.entry,
                            [&](int32_t column) { return here * scale[column]; });
                });
  }

  void relax_from_zero(CpuDepth& depth) override {
    step<true>(depth, depth.f, 0, first_step());
    compute_residual(depth);
    step<false>(depth, depth.r, kMomentum, kSecondStep);
  }

  void relax(CpuDepth& depth) override {
    compute_residual(depth);
    step<false>(depth, depth.r, 0, first_step());
    compute_residual(depth);
    step<false>(depth, depth.r, kMomentum, kSecondStep);
  }

  uint64_t byte_count() const override {
    return inverse_.byte_count() + bytes_of(inverses_) + bytes_of(direction_);
  }

 private:
  // The Chebyshev iteration of degree 2 for eigenvalues of M⁻¹S in [λmax/20, λmax]. Cells overlap
  // so that λmax is at most 27; 16 covered every scan and metric measured.
  static constexpr float kLambdaMax = 16;
  static constexpr float kCentre = kLambdaMax * (1 + 1 / 20.0f) / 2;
  static constexpr float kHalfWidth = kLambdaMax * (1 - 1 / 20.0f) / 2;
  static constexpr float kSigma = kCentre / kHalfWidth;
  static constexpr float kRho = 1 / (2 * kSigma - 1 / kSigma);
  static constexpr float kMomentum = kRho / kSigma;
  static constexpr float kSecondStep = 2 * kRho / kHalfWidth;
  static constexpr float first_step() { return 1 / kCentre; }

  static std::vector<float> scale_of(const CpuDepth& depth) {
    std::vector<float> scale(depth.inverse_diagonal.size());
    for (size_t i = 0; i < scale.size(); ++i) scale[i] = std::sqrt(depth.inverse_diagonal[i]);
    return scale;
  }

  void invert_cell(const CpuDepth& depth, const std::vector<float>& scale, int32_t cell) {
    Block block;
    read_scaled_block(depth, scale, cell, block);
    invert(block);
    CellInverse& out = inverses_[cell];
    for (int a = 0, p = 0; a < 8; ++a) {
      out.diagonal[a] = block[a][a];
      for (int b = a + 1; b < 8; ++b, ++p) out.pair[p] = (block[a][b] + block[b][a]) / 2;
    }
  }

  // d = momentum·d + length·M⁻¹ source; x += d, or x = d from zero.
  template <bool kFromZero>
  void step(CpuDepth& depth, const std::vector<Float4>& source, float momentum, float length) {
    const Stencil& stencil = depth.topology.stencil;
    const int32_t n = depth.corner_count();
#pragma omp parallel for schedule(static)
    for (int32_t corner = 0; corner < n; ++corner) {
      Float4 z = inverse_.own[corner] * source[corner];
      const int64_t end = stencil.row_start[corner + 1];
      for (int64_t k = stencil.row_start[corner]; k < end; ++k)
        z += inverse_.entry[k] * source[stencil.column[k]];
      Float4 direction = length * z;
      if (momentum != 0) direction += momentum * direction_[corner];
      direction_[corner] = direction;
      depth.x[corner] = kFromZero ? direction : Float4(depth.x[corner] + direction);
    }
  }

  std::vector<CellInverse> inverses_;
  StencilMatrix inverse_;  ///< M⁻¹ on the stencil: own = diagonal
  std::vector<Float4> direction_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_schwarz(const HierarchyDepth& topology) {
  return std::make_unique<Schwarz>(topology);
}

}  // namespace burnish::cpu

#include "server/session/fit_signal.h"

#include <array>
#include <utility>

#include "common/base/blocks.h"
#include "common/base/groups.h"
#include "common/evaluation/evaluation.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish {

namespace {

// Weight of the stiffness beside one vertex. Waves of ten cells lose less than 1e-3 by it. Less
// weight takes more steps, for combinations of corners that hardly reach a vertex.
constexpr double kFitStiffness = 1e-3;
constexpr int kFitStepsMax = 1000;  // noise takes 200
// A part of the right-hand side, in the norm of the inverse diagonal.
constexpr double kFitResidual = 1e-4;

/// A cell's share of the normal equations: pairs of corners, then the diagonal.
struct CellFit {
  std::array<float, kPairsPerCell> pair = {};
  std::array<float, kCornersPerCell> diagonal = {};
};

/// The normal equations Σ_v B(v) B(v)ᵀ + ε ℓ, and conjugate gradients for them.
class Fit {
 public:
  Fit(const Multigrid& on, std::span<const Vec3f> values)
      : prepared_(*on.prepared),
        grid_(on.hierarchy->at(on.hierarchy->finest).grid),
        cells_(grid_.cells.size()),
        inverse_diagonal_(grid_.corners.size()),
        solution_(grid_.corners.size()),
        residual_(grid_.corners.size()),
        direction_(grid_.corners.size()),
        product_(grid_.corners.size()) {
    const Groups<int32_t> vertices = group_vertices();
    sum_cells(vertices);
    begin(vertices, values);
  }

  SignalFit solve() {
    double energy = residual_energy();
    int step = 0;
    for (; step < kFitStepsMax && !is_near(energy); ++step) {
      advance(energy / multiply());
      const double before = std::exchange(energy, residual_energy());
      turn(energy / before);
    }
    return {std::move(solution_), step, is_near(energy)};
  }

 private:
  Groups<int32_t> group_vertices() const {
    return group_by<int32_t>(grid_.cell_count(), [&](auto&& add) {
      for (size_t v = 0; v < prepared_.evaluation.size(); ++v)
        if (prepared_.evaluation[v].cell != kNone)
          add(prepared_.evaluation[v].cell, static_cast<int32_t>(v));
    });
  }

  auto weights_at(int32_t vertex) const {
    return trilinear_weights(prepared_.evaluation[vertex].local);
  }

  void sum_cells(const Groups<int32_t>& vertices) {
#pragma omp parallel for schedule(static)
    for (int32_t cell = 0; cell < grid_.cell_count(); ++cell) {
      add_stiffness(cell);
      for (const int32_t vertex : vertices[cell]) add_vertex(weights_at(vertex), cells_[cell]);
    }
  }

  void add_stiffness(int32_t cell) {
    const CellIntegrals& of = prepared_.integrals[cell];
    CellFit& fit = cells_[cell];
    for (int a = 0; a < kCornersPerCell; ++a)
      for (int b = a + 1; b < kCornersPerCell; ++b) {
        const int pair = pair_index(a, b);
        const auto stiffness =
            static_cast<float>(kFitStiffness * (of.stiffness[0][pair] + of.stiffness[1][pair]));
        fit.pair[pair] += stiffness;
        fit.diagonal[a] -= stiffness;
        fit.diagonal[b] -= stiffness;
      }
  }

  static void add_vertex(const std::array<float, kCornersPerCell>& weights, CellFit& fit) {
    for (int a = 0; a < kCornersPerCell; ++a) {
      fit.diagonal[a] += weights[a] * weights[a];
      for (int b = a + 1; b < kCornersPerCell; ++b)
        fit.pair[pair_index(a, b)] += weights[a] * weights[b];
    }
  }

  // Begins at the mean of the values around each corner, or of all: a constant is met at once.
  void begin(const Groups<int32_t>& vertices, std::span<const Vec3f> values) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Vec3f& value : values) sum += value.cast<double>();
    const Vec3f mean = (sum / double(values.size())).cast<float>();
#pragma omp parallel for schedule(static)
    for (int32_t corner = 0; corner < grid_.corner_count(); ++corner) {
      float diagonal = 0, weight = 0;
      Vec3f right = Vec3f::Zero();
      for (int a = 0; a < kCornersPerCell; ++a) {
        const int32_t cell = grid_.cells_of_corner[corner][a];
        if (cell == kNone) continue;
        diagonal += cells_[cell].diagonal[a];
        for (const int32_t vertex : vertices[cell]) {
          const float share = weights_at(vertex)[a];
          weight += share;
          right += share * values[vertex];
        }
      }
      inverse_diagonal_[corner] = diagonal > 0 ? 1 / diagonal : 0;
      residual_[corner] = right;
      solution_[corner] = weight > 0 ? Vec3f(right / weight) : mean;
    }
    right_energy_ = residual_energy();
    std::swap(direction_, solution_);
    multiply();
    std::swap(direction_, solution_);
    for (size_t i = 0; i < residual_.size(); ++i) residual_[i] -= product_[i];
    direction_.assign(direction_.size(), Vec3f::Zero());
    turn(0);
  }

  bool is_near(double energy) const {
    return energy <= kFitResidual * kFitResidual * right_energy_;
  }

  // Makes the product with the direction. Returns the direction's product with it.
  double multiply() {
    return ordered_sum<double>(grid_.corner_count(), [&](int32_t begin, int32_t end) {
      double sum = 0;
      for (int32_t corner = begin; corner < end; ++corner) {
        product_[corner] = row_times_direction(corner);
        sum += product_[corner].dot(direction_[corner]);
      }
      return sum;
    });
  }

  Vec3f row_times_direction(int32_t corner) const {
    Vec3f product = Vec3f::Zero();
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t cell = grid_.cells_of_corner[corner][a];
      if (cell == kNone) continue;
      const CellFit& fit = cells_[cell];
      product += fit.diagonal[a] * direction_[corner];
      for (int step = 1; step < kCornersPerCell; ++step)
        product +=
            fit.pair[pair_index(a, a ^ step)] * direction_[grid_.cell_corners[cell][a ^ step]];
    }
    return product;
  }

  double residual_energy() const {
    return ordered_sum<double>(grid_.corner_count(), [&](int32_t begin, int32_t end) {
      double sum = 0;
      for (int32_t i = begin; i < end; ++i)
        sum += double{inverse_diagonal_[i]} * residual_[i].squaredNorm();
      return sum;
    });
  }

  void turn(double by) {
    const auto kept = static_cast<float>(by);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < direction_.size(); ++i)
      direction_[i] = inverse_diagonal_[i] * residual_[i] + kept * direction_[i];
  }

  void advance(double by) {
    const auto length = static_cast<float>(by);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < direction_.size(); ++i) {
      solution_[i] += length * direction_[i];
      residual_[i] -= length * product_[i];
    }
  }

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  std::vector<CellFit> cells_;
  std::vector<float> inverse_diagonal_;  // 0 where nothing holds a corner
  std::vector<Vec3f> solution_, residual_, direction_, product_;
  double right_energy_ = 0;
};

}  // namespace

SignalFit fit_signal(const Multigrid& on, std::span<const Vec3f> values) {
  return Fit(on, values).solve();
}

uint64_t predict_fit_bytes(const Multigrid& on) {
  const SparseGrid& grid = on.hierarchy->at(on.hierarchy->finest).grid;
  const uint64_t of_corner = sizeof(float) + 3 * sizeof(Vec3f);
  const uint64_t of_vertex = sizeof(Vec3f) + 2 * sizeof(int32_t);
  return grid.cells.size() * (sizeof(CellFit) + sizeof(int64_t)) + grid.corners.size() * of_corner +
         on.prepared->vertices.size() * of_vertex;
}

}  // namespace burnish

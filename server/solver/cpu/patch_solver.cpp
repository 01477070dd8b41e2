#include "server/solver/cpu/patch_solver.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Cholesky>

#include "common/base/check.h"

namespace burnish::cpu {

// On the unit diagonal of the scaled block: ten times float32's rounding. What hangs by a sliver
// has eigenvalues of 1e-5; of less than 1e-6 rounding grows over idle steps.
static constexpr double kRegularisation = 1e-6;
static constexpr double kRegularisationMax = 100;  // rows have 27 entries of at most about 1

namespace {

using PatchMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor,
                                  kPatchCornersMax, kPatchCornersMax>;

std::span<const int32_t> corners_of(const Patches& patches, int32_t patch) {
  return std::span(patches.corner)
      .subspan(patches.start[patch], patches.start[patch + 1] - patches.start[patch]);
}

PatchMatrix scaled_block(const CpuDepth& depth, std::span<const int32_t> corners) {
  const Stencil& stencil = depth.topology.stencil;
  const auto n = static_cast<Eigen::Index>(corners.size());
  PatchMatrix block = PatchMatrix::Identity(n, n);
  const auto scale = [&](int32_t corner) {
    return std::sqrt(double{depth.inverse_diagonal[corner]});
  };
  for (Eigen::Index i = 0; i < n; ++i)
    for (auto [k, end] = stencil.row(corners[i]); k < end; ++k) {
      const auto there = std::ranges::lower_bound(corners, stencil.column[k]);
      if (there == corners.end() || *there != stencil.column[k]) continue;
      block(i, there - corners.begin()) =
          depth.system.entry[k] * scale(corners[i]) * scale(stencil.column[k]);
    }
  return block;
}

// The lower triangular inverse of the factor of a scaled block.
PatchMatrix inverse_factor(PatchMatrix block) {
  block.diagonal().array() += kRegularisation;
  Eigen::LLT<PatchMatrix> factor(block);
  for (double more = 9 * kRegularisation; factor.info() != Eigen::Success; more *= 10) {
    BURNISH_CHECK(more < kRegularisationMax, "a patch's matrix is finite");
    block.diagonal().array() += more;
    factor.compute(block);
  }
  PatchMatrix inverse = PatchMatrix::Identity(block.rows(), block.cols());
  factor.matrixL().solveInPlace(inverse);
  return inverse;
}

Float4 residual_at(const CpuDepth& depth, int32_t corner) {
  if (depth.inverse_diagonal[corner] == 0) return Float4::Zero();
  return depth.f[corner] - product_row(depth.topology.stencil, depth.system, depth.x, corner);
}

}  // namespace

PatchSolver::PatchSolver(const HierarchyDepth& topology)
    : patches_(topology.patches), factor_inverse_(topology.patches.entry_count()) {}

void PatchSolver::factor(const CpuDepth& depth) {
#pragma omp parallel for schedule(dynamic)
  for (int32_t patch = 0; patch < patches_.count(); ++patch) factor(depth, patch);
}

void PatchSolver::factor(const CpuDepth& depth, int32_t patch) {
  const std::span<const int32_t> corners = corners_of(patches_, patch);
  const PatchMatrix inverse = inverse_factor(scaled_block(depth, corners));
  float* entry = factor_inverse_.data() + patches_.entry_start[patch];
  for (size_t i = 0; i < corners.size(); ++i)
    for (size_t j = 0; j <= i; ++j)
      *entry++ = static_cast<float>(inverse(i, j) * std::sqrt(depth.inverse_diagonal[corners[j]]));
}

// x += WᵀW (f − S x) at the patch's corners.
void PatchSolver::relax(CpuDepth& depth, int32_t patch) const {
  const std::span<const int32_t> corners = corners_of(patches_, patch);
  std::array<Float4, kPatchCornersMax> residual, correction;
  for (size_t i = 0; i < corners.size(); ++i) residual[i] = residual_at(depth, corners[i]);
  std::fill_n(correction.begin(), corners.size(), Float4(Float4::Zero()));
  const float* entry = factor_inverse_.data() + patches_.entry_start[patch];
  for (size_t i = 0; i < corners.size(); entry += ++i) {
    Float4 sum = Float4::Zero();
    for (size_t j = 0; j <= i; ++j) sum += entry[j] * residual[j];
    for (size_t j = 0; j <= i; ++j) correction[j] += entry[j] * sum;
  }
  for (size_t i = 0; i < corners.size(); ++i) depth.x[corners[i]] += correction[i];
}

void PatchSolver::relax_colour(CpuDepth& depth, int32_t colour) const {
  const int32_t begin = patches_.colour_start[colour], end = patches_.colour_start[colour + 1];
#pragma omp parallel for schedule(dynamic)
  for (int32_t patch = begin; patch < end; ++patch) relax(depth, patch);
}

void PatchSolver::relax_forwards(CpuDepth& depth) const {
  for (int32_t colour = 0; colour < patches_.colour_count(); ++colour) relax_colour(depth, colour);
}

void PatchSolver::relax_backwards(CpuDepth& depth) const {
  for (int32_t colour = patches_.colour_count(); colour-- > 0;) relax_colour(depth, colour);
}

}  // namespace burnish::cpu

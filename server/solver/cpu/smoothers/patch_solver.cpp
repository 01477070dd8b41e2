#include "server/solver/cpu/smoothers/patch_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <Eigen/Cholesky>

#include "common/base/check.h"
#include "common/base/parallel.h"

namespace burnish::cpu {

// Added to the unit diagonal of the scaled block: ten times float32's rounding. Surface that hangs
// by a sliver has eigenvalues of 1e-5. With less than 1e-6 rounding grows over idle steps.
static constexpr double kRegularisation = 1e-6;
static constexpr double kRegularisationMax = 100;  // rows have 27 entries of at most about 1
static constexpr int32_t kPatchesAlone = 16;       // for fewer, waking threads takes longer

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

PatchMatrix cholesky_factor(PatchMatrix block) {
  block.diagonal().array() += kRegularisation;
  Eigen::LLT<PatchMatrix> factor(block);
  for (double more = 9 * kRegularisation; factor.info() != Eigen::Success; more *= 10) {
    BURNISH_CHECK(more < kRegularisationMax, "a patch's matrix is finite");
    block.diagonal().array() += more;
    factor.compute(block);
  }
  return factor.matrixLLT();
}

Float4 residual_at(const CpuDepth& depth, int32_t corner) {
  if (depth.inverse_diagonal[corner] == 0) return Float4::Zero();
  return depth.f[corner] - product_row(depth.topology.stencil, depth.system, depth.x, corner);
}

// Does x = (L Lᵀ)⁻¹ x, row by row, and back.
void solve_factored(const float* entry, std::span<Float4> x) {
  const float* row = entry;
  for (size_t i = 0; i < x.size(); row += ++i) {
    for (size_t j = 0; j < i; ++j) x[i] -= row[j] * x[j];
    x[i] *= row[i];
  }
  for (size_t i = x.size(); i-- > 0;) {
    row -= i + 1;
    x[i] *= row[i];
    for (size_t j = 0; j < i; ++j) x[j] -= row[j] * x[i];
  }
}

}  // namespace

PatchSolver::PatchSolver(const Patches& patches)
    : patches_(patches), entry_(patches.entry_count()) {}

void PatchSolver::factor(const CpuDepth& depth) {
  std::vector<int32_t> all(patches_.count());
  std::iota(all.begin(), all.end(), 0);
  factor_some(depth, all);
}

void PatchSolver::factor(const CpuDepth& depth, std::span<const int32_t> corners) {
  std::vector<int32_t> which;
  std::vector<uint8_t> is_new(depth.corner_count(), 0);
  for (const int32_t corner : corners) is_new[corner] = 1;
  for (int32_t patch = 0; patch < patches_.count(); ++patch)
    if (std::ranges::any_of(corners_of(patches_, patch), [&](int32_t i) { return is_new[i] != 0; }))
      which.push_back(patch);
  factor_some(depth, which);
}

void PatchSolver::factor_some(const CpuDepth& depth, std::span<const int32_t> which) {
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic) if (which.size() > 1)
  for (const int32_t patch : which) failure.run([&] { factor_one(depth, patch); });
  failure.rethrow();
}

void PatchSolver::factor_one(const CpuDepth& depth, int32_t patch) {
  const std::span<const int32_t> corners = corners_of(patches_, patch);
  const PatchMatrix factor = cholesky_factor(scaled_block(depth, corners));
  float* entry = entry_.data() + patches_.entry_start[patch];
  for (size_t i = 0; i < corners.size(); ++i) {
    const double inverse_scale = std::sqrt(double{depth.system.diagonal[corners[i]]});
    const bool is_free = depth.inverse_diagonal[corners[i]] > 0;
    for (size_t j = 0; j < i; ++j) *entry++ = is_free ? factor(i, j) * inverse_scale : 0;
    *entry++ = is_free ? 1 / (factor(i, i) * inverse_scale) : 0;
  }
}

// Does x += S⁻¹ (f − S x) at the patch's corners.
void PatchSolver::relax(CpuDepth& depth, int32_t patch) const {
  const std::span<const int32_t> corners = corners_of(patches_, patch);
  std::array<Float4, kPatchCornersMax> room;
  const std::span correction = std::span(room).first(corners.size());
  for (size_t i = 0; i < corners.size(); ++i) correction[i] = residual_at(depth, corners[i]);
  solve_factored(entry_.data() + patches_.entry_start[patch], correction);
  for (size_t i = 0; i < corners.size(); ++i) depth.x[corners[i]] += correction[i];
}

void PatchSolver::relax_colour(CpuDepth& depth, int32_t colour) const {
  const int32_t begin = patches_.colour_start[colour], end = patches_.colour_start[colour + 1];
#pragma omp parallel for schedule(dynamic) if (end - begin > kPatchesAlone)
  for (int32_t patch = begin; patch < end; ++patch) relax(depth, patch);
}

void PatchSolver::relax_forwards(CpuDepth& depth) const {
  for (int32_t colour = 0; colour < patches_.colour_count(); ++colour) relax_colour(depth, colour);
}

void PatchSolver::relax_backwards(CpuDepth& depth) const {
  for (int32_t colour = patches_.colour_count(); colour-- > 0;) relax_colour(depth, colour);
}

}  // namespace burnish::cpu

#pragma once

#include <cuda_runtime.h>

#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Does TransferCurve::alpha(). Needs: two points or more.
__device__ inline float alpha_at(const AlphaSource& source, double kappa) {
  int right = 1;
  while (right < source.point_count - 1 && source.kappa[right] <= kappa) ++right;
  const double left = source.kappa[right - 1];
  const double t = fmin(fmax((kappa - left) / (source.kappa[right] - left), 0.0), 1.0);
  return static_cast<float>(
      exp(source.log_alpha[right - 1] * (1 - t) + source.log_alpha[right] * t));
}

/// Returns the cell's entry in a part of a list that ascends by cell; null if it has none.
template <typename Entry>
__device__ inline const Entry* find_entry(const Entry* list, int32_t first, int32_t end,
                                          int64_t cell) {
  while (first < end) {
    const int32_t middle = (first + end) / 2;
    if (list[middle].cell == cell) return list + middle;
    if (list[middle].cell < cell)
      first = middle + 1;
    else
      end = middle;
  }
  return nullptr;
}

/// Returns null if the cell follows the curve.
__device__ inline const OwnAlpha* own_alpha_of(const AlphaSource& source, int64_t cell) {
  return find_entry(source.own, 0, source.own_count, cell);
}

/// Returns null if no held line passes the cell.
__device__ inline const HeldLine* held_line_of(const AlphaSource& source, int64_t cell) {
  if (source.first_line == nullptr) return nullptr;
  const int32_t* const bounds = source.first_line + cell / HeldLine::kStretch;
  return find_entry(source.lines, bounds[0], bounds[1], cell);
}

/// Returns α1 and α2 of a cell. Units: user units.
__device__ inline float2 alpha_of(const AlphaSource& source, const Curvature* curvature,
                                  int64_t cell) {
  if (const OwnAlpha* own = own_alpha_of(source, cell)) return {own->alpha1, own->alpha2};
  if (source.point_count == 1) {
    const auto alpha = static_cast<float>(exp(source.log_alpha[0]));
    return {alpha, alpha};
  }
  const Curvature of = curvature[cell];
  return {alpha_at(source, of.kappa1), alpha_at(source, of.kappa2)};
}

}  // namespace burnish::cuda

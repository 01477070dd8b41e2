#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// r = f − S x, zero where pinned.
void compute_residual(Stream& stream, const Depth& depth);

/// coarse.f = Pᵀ fine.r, zero where pinned.
void restrict_to_coarse(Stream& stream, const Depth& fine, const Depth& coarse);

/// fine.x = 0, coarse.f = Pᵀ fine.f, zero where pinned.
void restrict_from_zero(Stream& stream, const Depth& fine, const Depth& coarse);

/// fine.x += P coarse.x, but not where pinned.
void add_prolonged(Stream& stream, const Depth& coarse, const Depth& fine);

}  // namespace burnish::cuda

#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Does r = f − S x, zero at pinned corners.
void compute_residual(Stream& stream, const Depth& depth);

/// Does coarse.f = Pᵀ fine.r, zero at pinned corners.
void restrict_to_coarse(Stream& stream, const Depth& fine, const Depth& coarse);

/// Does fine.x = 0, coarse.f = Pᵀ fine.f, zero at pinned corners.
void restrict_from_zero(Stream& stream, const Depth& fine, const Depth& coarse);

/// Does fine.x += P coarse.x, except at pinned corners.
void add_prolonged(Stream& stream, const Depth& coarse, const Depth& fine);

}  // namespace burnish::cuda

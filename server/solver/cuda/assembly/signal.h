#pragma once

#include "server/solver/cuda/assembly/combined_cells.h"
#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Replaces what a new metric makes of the surface's own places by the same of another signal: the
/// gradients of the cells, Σ_b ℓ_ab s_b, and b's change per slider step. Shapes: one per corner.
void make_signal_gradients(Stream& stream, const Integrals& integrals, const Metric& metric,
                           const Depth& finest, const float3* signal, Double3* per_slider);

}  // namespace burnish::cuda

#pragma once

#include "server/solver/cuda/stream.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// α1, α2 and β per cell, on the device.
struct FieldArrays {
  const float* alpha1;
  const float* alpha2;
  const float* beta;
};

/// b_I = Σ_c (β−1)(α2/α1 g¹ + α1/α2 g²)_I, the right-hand side for the displacement: Eq. 4's
/// constraint less S c°; the residual r changes by as much. Zero where pinned.
void assemble_constraint(Stream& stream, const Depth& finest, const Gradients& gradients,
                         const FieldArrays& fields, Double3* b, Double3* r);

}  // namespace burnish::cuda

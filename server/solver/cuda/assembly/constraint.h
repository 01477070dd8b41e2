#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Makes b_I = Σ_c (β−1) combined_I, the right-hand side for the displacement: Eq. 4's constraint
/// less S c°; with a target, what TargetView says. Keeps the slider's part and the rest apart.
/// Changes r by the same amount, unless gradients are new: only a new metric makes them new, and
/// then r is recomputed anyway. A slider alone moves r by b's change per slider step, whatever is
/// painted. New paint gathers the slices of corners that it touches, a new target all. Needs: b as
/// the last call left it; after new gradients, assembly.h has made b's change per slider step.
void assemble_constraint(Stream& stream, const Depth& finest, const CellGradients& combined,
                         const NewGradientScale& beta, const NewTarget& target,
                         bool gradients_are_new, const Constraint& b, Double3* r);

}  // namespace burnish::cuda

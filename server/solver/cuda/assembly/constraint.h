#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// b_I = Σ_c (β−1) combined_I, the right-hand side for the displacement: Eq. 4's constraint less
/// S c°, in what is the slider's of it and what is paint's own. The residual r changes by as much,
/// unless gradients are new, which only a new metric makes them: then it is to be recomputed
/// anyway. A slider alone moves r by what b has per slider, whatever is painted; new paint gathers
/// the slices of corners that it touches. Needs: b is as it was left here; what it has per slider
/// of gradients that are new is there (assembly.h).
void assemble_constraint(Stream& stream, const Depth& finest, const CellGradients& combined,
                         const NewGradientScale& beta, bool gradients_are_new, const Constraint& b,
                         Double3* r);

}  // namespace burnish::cuda

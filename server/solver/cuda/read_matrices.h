#pragma once

#include <vector>

#include "server/solver/cuda/device/named_bits.h"
#include "server/solver/cycle/backend.h"

namespace burnish::cuda {

/// Returns all that a metric makes of a backend of make_cuda_backend(), but estimates of spectra:
/// the matrices and inverse diagonals of all depths, M⁻¹ of the default smoother, the factors of
/// patches and the coarsest depth, and the constraint's part for the slider. For tests.
std::vector<NamedBits> read_matrices(Backend& backend);

}  // namespace burnish::cuda

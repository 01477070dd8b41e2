#pragma once

#include "server/solver/cpu/chebyshev.h"
#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// The loops in which the V-cycle spends its time: products of a depth's rows with a vector, each
/// with what is done to the result while it is in registers.

/// r = f − S x, zero where pinned.
void compute_residual(CpuDepth& depth);

/// One step of the Chebyshev iteration from x along d = momentum·d + length·A source: x += d, or
/// x = d when the iteration starts from x = 0.
struct RelaxAlong {
  const std::vector<Float4>& source;
  ChebyshevStep step;
  bool from_zero = false;
  const std::vector<Float4>* last_d = nullptr;  ///< none: no momentum
  std::vector<Float4>* d = nullptr;             ///< none: no later step needs it
};
void relax_along(CpuDepth& depth, const StencilMatrix& a, const RelaxAlong& relax);

/// q = S p for the exact S as Σ_J S_IJ (p_J − p_I) + m_I p_I, which loses nothing for smooth p;
/// zero where pinned. For the corners [begin, end), which start and end with tiles of the stencil or
/// with the corners. Starts no threads.
void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Float4>& p,
                   std::vector<Double4>& q, int32_t begin, int32_t end);
void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Double4>& p,
                   std::vector<Double4>& q, int32_t begin, int32_t end);

}  // namespace burnish::cpu

#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cycle/smoother_names.h"

namespace burnish::cpu {

/// Relaxes one depth. relax() is the transpose of relax_from_zero(), so the V-cycle stays
/// symmetric. One object serves one depth.
class DepthSmoother {
 public:
  virtual ~DepthSmoother() = default;
  virtual void set_up(CpuDepth& depth) = 0;  ///< call after a new matrix; changes x, f, r
  /// Does the same, with the same bits, if the rows of S or the pins of some corners alone are new.
  virtual void update(CpuDepth& depth, std::span<const int32_t> corners) {
    (void)corners;
    set_up(depth);
  }
  /// Regularises by the size of the blocks from the next set_up() on, so that none can fail; or
  /// as usual again.
  virtual void be_careful(bool careful) { (void)careful; }
  virtual void start_over() {}                        ///< forgets what earlier matrices taught it
  virtual void relax_from_zero(CpuDepth& depth) = 0;  ///< x from zero
  virtual void relax(CpuDepth& depth) = 0;            ///< continues from x
  virtual uint64_t byte_count() const = 0;
};

/// Makes Chebyshev of degree 2 on additive Schwarz over cells: M⁻¹ = Σ_c R_cᵀ (B_c + reg)⁻¹ R_c
/// with B_c the 8×8 block of the diagonally scaled S at the corners of cell c.
std::unique_ptr<DepthSmoother> make_schwarz(const HierarchyDepth& topology);

/// Makes one sweep over the same blocks one after the other: multiplicative, while Schwarz is
/// additive. Bricks of cells have eight colours (the parity of the brick). After the coarse
/// correction the sweep runs backwards.
std::unique_ptr<DepthSmoother> make_cell_blocks(const HierarchyDepth& topology);

/// Makes Chebyshev of degree 4 on the diagonal.
std::unique_ptr<DepthSmoother> make_chebyshev_jacobi(const HierarchyDepth& topology);

/// Makes true Gauss-Seidel in eight colours (the parity of the corner), two sweeps, like the
/// paper's V(2,2). After the coarse correction the colours run backwards.
std::unique_ptr<DepthSmoother> make_gauss_seidel(const HierarchyDepth& topology);

struct SliceOptions {
  int sweeps = 2;  ///< like the paper's V(2,2)
  int blocks = 0;  ///< 0: one per thread; any number gives the same bits
  bool temporal_blocking = false;
};

/// Makes Gauss-Seidel over slices of corners: in a sweep the even slices come before the odd ones.
/// A thread does all sweeps on its block of slices and an overlap, without waiting for other
/// threads. Source: section 5.2, "Parallelization" and "Temporal Blocking".
std::unique_ptr<DepthSmoother> make_slices(const HierarchyDepth& topology,
                                           const SliceOptions& options);

std::unique_ptr<DepthSmoother> make_smoother(Smoother kind, const HierarchyDepth& topology);

}  // namespace burnish::cpu

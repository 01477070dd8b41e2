#pragma once

#include <optional>

#include "server/solver/cpu/products/coarsest.h"
#include "server/solver/cuda/products/dense_inverse.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cuda {

/// The direct solve of the coarsest depth. On the device up to DenseInverse::kCornersMax corners;
/// above, which takes hundreds of separate pieces of surface, the host's sparse factor, at a copy
/// there and back in every cycle.
class CoarsestSolver {
 public:
  CoarsestSolver(Stream& stream, const HierarchyDepth& topology, const Depth& depth);

  void factor();
  void solve();  ///< x = S⁻¹ f
  /// Whether solve() stays on the device, and so may be part of a graph.
  bool on_device() const { return !host_.has_value(); }
  uint64_t byte_count() const { return dense_.byte_count(); }

 private:
  void read_matrix();

  Stream& stream_;
  Depth depth_;
  DenseInverse dense_;
  std::optional<cpu::CpuDepth> host_;
  cpu::CoarsestSolver host_solver_;
};

}  // namespace burnish::cuda

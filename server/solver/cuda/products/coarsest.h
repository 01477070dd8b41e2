#pragma once

#include <optional>

#include "server/solver/cpu/products/coarsest.h"
#include "server/solver/cuda/products/dense_inverse.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cuda {

/// Solves the coarsest depth directly. Up to DenseInverse::kCornersMax corners it solves on the
/// device. More corners need hundreds of separate pieces of surface; then the host's sparse factor
/// solves, with a copy there and back in every cycle.
class CoarsestSolver {
 public:
  CoarsestSolver(Stream& stream, const HierarchyDepth& topology, const Depth& depth);

  void factor();
  void solve();  ///< x = S⁻¹ f
  /// Returns whether solve() stays on the device, so that it can be part of a graph.
  bool on_device() const { return !host_.has_value(); }
  uint64_t byte_count() const { return dense_.byte_count(); }
  /// Appends the inverse, if it is on the device.
  void read(std::vector<NamedBits>& to) const { dense_.read(stream_, to); }

 private:
  void read_matrix();

  Stream& stream_;
  Depth depth_;
  DenseInverse dense_;
  std::optional<cpu::CpuDepth> host_;
  cpu::CoarsestSolver host_solver_;
};

}  // namespace burnish::cuda

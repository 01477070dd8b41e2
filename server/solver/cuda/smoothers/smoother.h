#pragma once

#include <memory>

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cycle/smoother_names.h"

namespace burnish {
struct HierarchyDepth;
}

namespace burnish::cuda {

/// Relaxes one depth. relax() is the transpose of relax_from_zero(), so that the V-cycle stays
/// symmetric. One object per depth.
class DepthSmoother {
 public:
  virtual ~DepthSmoother() = default;

  /// Where set_up() works, until finish_set_up() beside what else the stream does. It comes after
  /// all that the stream has been given so far.
  virtual Stream& fork() = 0;
  virtual Stream& beside() = 0;  ///< the same without a fork: after what is done there
  /// What assemble() is to leave S times in r, for set_up() to go on from; null for nothing.
  virtual const float4* probe() const { return nullptr; }
  /// After a new matrix. Leaves r changed, f too the first time. `inverses` is working memory;
  /// `anisotropy` the largest ratio of α1 and α2 of any cell, on the device.
  virtual void set_up(const CellSquares<float>& inverses, const float* anisotropy) = 0;
  virtual void finish_set_up() = 0;

  virtual void relax_from_zero() = 0;  ///< x from zero
  virtual void relax() = 0;            ///< x further
  virtual uint64_t byte_count() const = 0;
};

/// Needs: `kind` is one of kCudaSmoothers.
std::unique_ptr<DepthSmoother> make_smoother(Smoother kind, Stream& stream,
                                             const HierarchyDepth& topology, const Depth& depth,
                                             bool has_weak_parts);

}  // namespace burnish::cuda

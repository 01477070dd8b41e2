#pragma once

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/read_bits.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/patches.h"

namespace burnish::cuda {

/// Solves the finest depth's patches for the current residual, a block of threads for each, colour
/// after colour: see cpu/smoothers/patch_solver.h.
class PatchSolver {
 public:
  /// Keeps a reference to `patches`.
  PatchSolver(Stream& stream, const Depth& depth, const Patches& patches, const PatchList& list);

  /// Call after a new matrix. Factors the patches with a corner in the listed blocks of rows, or
  /// all.
  void factor(Stream& stream, const BlockList& rows);
  void relax_forwards();
  void relax_backwards();
  uint64_t byte_count() const { return factor_inverse_.byte_count(); }
  /// Appends the factors.
  void read(std::vector<NamedBits>& to) const {
    read_bits(stream_, "factors of patches", factor_inverse_, to);
  }

 private:
  void relax_colour(int32_t colour);

  Stream& stream_;
  Depth depth_;
  const Patches& patches_;
  PatchList list_;
  DeviceArray<float> factor_inverse_;  // W of every patch, its lower triangle by rows
  size_t shared_bytes_;                // of the kernel that factors the largest patch
};

}  // namespace burnish::cuda

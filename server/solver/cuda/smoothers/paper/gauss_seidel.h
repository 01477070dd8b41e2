#pragma once

#include <array>

#include "server/solver/cuda/device/branch.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/smoothers/smoother.h"

namespace burnish::cuda {

/// Point Gauss-Seidel in eight colours (the parity of the corner), two sweeps, like the paper's
/// V(2,2). After the coarse correction the colours run backwards. Corners of one colour share no
/// cell, so a launch relaxes them all. It is for comparison, and as plain as possible. Needs: no
/// irregular rows (Sheets::kTogether).
class GaussSeidel final : public DepthSmoother {
 public:
  static constexpr int kColours = 8;

  /// A copy of S by colour: a place for every corner; each colour starts with a whole slice. Entry
  /// k of the corner at place p stands at slice_start[p / 32] + 32 k + p % 32.
  struct Rows {
    const int32_t* corner;  ///< -1 in the unused places of a colour's last slice
    const int64_t* slice_start;
    const int32_t* column;  ///< -1 beyond the end of a row
    float* entry;
  };

  GaussSeidel(Stream& stream, const HierarchyDepth& topology, const Depth& depth);

  Stream& fork() override;
  Stream& beside() override { return branch_.stream(); }
  void set_up(const CellSquares<float>& inverses, const float* anisotropy) override;
  void finish_set_up() override { branch_.join(); }
  void relax_from_zero() override;
  void relax() override;
  uint64_t byte_count() const override;

 private:
  void relax_colour(int colour);

  Stream& stream_;
  Branch branch_{stream_};
  Depth depth_;
  std::array<int64_t, kColours + 1> first_place_;
  DeviceArray<int32_t> corner_, column_;
  DeviceArray<int64_t> slice_start_;
  DeviceArray<float> entry_;
  Rows rows_;
};

}  // namespace burnish::cuda

#pragma once

#include "server/solver/cuda/branch.h"
#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/spectrum.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// Chebyshev of degree 2 on additive Schwarz over cells: M⁻¹ = Σ_c R_cᵀ (B_c + reg)⁻¹ R_c with B_c
/// the 8×8 block of the diagonally scaled S at the corners of cell c. relax() is the transpose of
/// relax_from_zero().
class Schwarz {
 public:
  Schwarz(Stream& stream, const Depth& depth);

  /// Where set_up() works, until finish_set_up() beside what else the stream does. It comes after
  /// all that the stream has been given so far.
  Stream& fork();
  /// What assemble() is to leave S times in r, for set_up() to go on from.
  const float4* probe() const { return eigenvector_.data(); }
  /// After a new matrix. Leaves r changed, f too the first time. `inverses` is working memory;
  /// `anisotropy` the largest ratio of α1 and α2 of any cell, on the device.
  void set_up(const CellSquares<float>& inverses, const float* anisotropy);
  Stream& beside() { return branch_.stream(); }  ///< where set_up() works
  void finish_set_up() { branch_.join(); }
  void relax_from_zero();
  void relax();
  uint64_t byte_count() const;

 private:
  void start_estimate(const PowerStep& power);

  Stream& stream_;
  Branch branch_{stream_};
  Depth depth_;
  DeviceArray<uint32_t> packed_;  // M⁻¹
  DeviceArray<float> diagonal_;
  DeviceArray<float4> direction_, eigenvector_;
  DeviceArray<Sums<2>> sums_;
  DeviceArray<unsigned> arrived_;
  DeviceArray<Spectrum> spectrum_;
  Matrix inverse_;
  bool first_ = true;
};

}  // namespace burnish::cuda

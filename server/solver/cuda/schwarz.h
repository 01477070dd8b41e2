#pragma once

#include "server/solver/cuda/branch.h"
#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/smoother.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// Chebyshev of degree 2 on additive Schwarz over cells: M⁻¹ = Σ_c R_cᵀ (B_c + reg)⁻¹ R_c with B_c
/// the 8×8 block of the diagonally scaled S at the corners of cell c. relax() is the transpose of
/// relax_from_zero().
class Schwarz final : public DepthSmoother {
 public:
  /// λmax of M⁻¹S as found so far, and the iteration's steps for it.
  struct Spectrum {
    float lambda_max;
    float normalise;  ///< keeps the power iteration's vector near one
    float first_step, momentum, second_step;
  };

  Schwarz(Stream& stream, const Depth& depth);

  Stream& fork() override;
  void set_up(const CellSquares<float>& inverses, const float* anisotropy) override;
  void finish_set_up() override { branch_.join(); }
  void relax_from_zero() override;
  void relax() override;
  uint64_t byte_count() const override;

 private:
  void estimate_lambda_max(const float* anisotropy);

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

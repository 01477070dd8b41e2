#pragma once

#include "server/solver/cuda/device/branch.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cuda/smoothers/smoother.h"
#include "server/solver/cuda/smoothers/spectrum.h"

namespace burnish::cuda {

/// Chebyshev of degree 2 on additive Schwarz over cells: M⁻¹ = Σ_c R_cᵀ (B_c + reg)⁻¹ R_c with B_c
/// the 8×8 block of the diagonally scaled S at the corners of cell c. relax() is the transpose of
/// relax_from_zero().
class Schwarz final : public DepthSmoother {
 public:
  /// With rests M⁻¹ has all digits of a float, and almost no regularisation. This needs rests of S,
  /// and no irregular row.
  /// `halo`: to the other shards, which have this depth as `number`; null if the depth is whole.
  Schwarz(Stream& stream, const Depth& depth, bool with_rests, Halo* halo, int number);

  Stream& fork() override;
  Stream& beside() override { return branch_.stream(); }
  const float4* probe() const override { return eigenvector_.data(); }
  void set_up(const CellSquares<float>& inverses, const float* anisotropy) override;
  void update(const CellSquares<float>& inverses, const float* anisotropy,
              const Touched& touched) override;
  void finish_set_up() override { branch_.join(); }
  void be_careful(bool careful) override { is_careful_ = careful; }
  void start_over() override { first_ = true; }
  void relax_from_zero() override;
  void relax() override;
  uint64_t byte_count() const override;
  void read(const std::string& name, std::vector<NamedBits>& to) override;

 private:
  PowerStep power_step(const float* anisotropy) const;
  void start_estimate(const PowerStep& power);
  void finish_iteration(const PowerStep& power);
  void refresh(Stream& stream, float4* vector);
  template <typename Kernel>
  void step(Kernel kernel, const float4* source);

  Stream& stream_;
  Branch branch_{stream_};
  Depth depth_;
  DeviceArray<uint32_t> packed_;  // M⁻¹
  DeviceArray<float> long_entries_, rest_, diagonal_;
  DeviceArray<float4> direction_, eigenvector_;
  DeviceArray<Sums<2>> sums_;
  DeviceArray<unsigned> arrived_;
  DeviceArray<Spectrum> spectrum_;
  DeviceArray<double> totals_;  // for the other shards
  Matrix inverse_;
  Halo* halo_;
  int number_;  // of the depth
  bool first_ = true;
  bool is_careful_ = false;
};

}  // namespace burnish::cuda

#include "server/solver/cuda/assembly/cell_alpha.h"
#include "server/solver/cuda/assembly/cell_gradients.h"
#include "server/solver/cuda/assembly/gradient_shares.h"
#include "server/solver/cuda/assembly/signal.h"
#include "server/solver/cuda/device/kernel.h"

namespace burnish::cuda {

namespace {

__device__ double axis_of(const float3& value, int axis) {
  return axis == 0 ? value.x : axis == 1 ? value.y : value.z;
}

// Rows of ℓ add up to zero, so only differences count: a constant has no share.
template <bool kRests>
__global__ void signal_gradients_kernel(Integrals integrals, Metric metric, Topology finest,
                                        const float3* signal) {
  constexpr int kFirst = Integrals::kMasses + Integrals::kRowSums;
  await_previous();
  const int64_t cell = thread_index();
  if (cell >= finest.cell_count) return;
  const float2 alpha = alpha_of(*metric.alpha, metric.curvature, cell);
  const CombineWeights weights = combine_weights(alpha.x * metric.scale, alpha.y * metric.scale);
  const auto integral = [&](int n) {
    return __ldg(integrals.numbers + n * integrals.cells + cell);
  };
  const auto stiffness = [&](int pair) {
    return weights.stiffness1 * integral(kFirst + pair) +
           weights.stiffness2 * integral(kFirst + Integrals::kStiffnesses + pair);
  };
  const Eight corners = finest.cell_corners[cell];
  float3 at[8];
#pragma unroll
  for (int a = 0; a < 8; ++a) at[a] = signal[corners.at[a]];
  const auto share = [&](int a, int axis) {
    double sum = 0;
#pragma unroll
    for (int step = 1; step < 8; ++step)
      sum +=
          stiffness(pair_index(a, a ^ step)) * (axis_of(at[a ^ step], axis) - axis_of(at[a], axis));
    return sum;
  };
  write_axis<0, kRests>([&](int a) { return share(a, 0); }, cell, metric.gradients);
  write_axis<1, kRests>([&](int a) { return share(a, 1); }, cell, metric.gradients);
  write_axis<2, kRests>([&](int a) { return share(a, 2); }, cell, metric.gradients);
}

template <bool kRests>
__global__ void per_slider_kernel(CellGradients gradients, Topology finest, Double3* per_slider) {
  await_previous();
  const int64_t corner = thread_index();
  if (corner < finest.corner_count)
    per_slider[corner] = sum_shares<kRests>(gradients, finest.cells_of_corner[corner]);
}

}  // namespace

void make_signal_gradients(Stream& stream, const Integrals& integrals, const Metric& metric,
                           const Depth& finest, const float3* signal, Double3* per_slider) {
  const bool rests = metric.gradients.rests != nullptr;
  const Topology& topology = finest.topology;
  launch(stream, rests ? signal_gradients_kernel<true> : signal_gradients_kernel<false>,
         topology.cell_count, integrals, metric, topology, signal);
  launch(stream, rests ? per_slider_kernel<true> : per_slider_kernel<false>, topology.corner_count,
         metric.gradients, topology, per_slider);
}

}  // namespace burnish::cuda

#include "server/solver/cuda/cell_inverse.h"
#include "server/solver/cuda/reduce.h"
#include "server/solver/cuda/schwarz.h"
#include "server/solver/cuda/transfer.h"
#include "server/solver/schwarz_bounds.h"

namespace burnish::cuda {

namespace {

constexpr int kIterationsFirst = 15;
constexpr int kIterationsNext = 1;

enum class Step { kFromZero, kFirst, kSecond };

// d = momentum·d + length·M⁻¹ source; x += d, or x = d from zero.
template <Step kStep>
__global__ void step_kernel(Depth depth, Matrix inverse, const float4* source,
                            const Schwarz::Spectrum* spectrum, float4* direction) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= depth.topology.corner_count) return;
  const auto corner = static_cast<int32_t>(i);
  const float4 product = product_row(depth.topology.rows, inverse, source, corner);
  float4 d;
  if constexpr (kStep == Step::kSecond)
    d = spectrum->momentum * direction[i] + spectrum->second_step * product;
  else
    d = spectrum->first_step * product;
  if constexpr (kStep != Step::kSecond) direction[i] = d;
  depth.x[i] = kStep == Step::kFromZero ? d : depth.x[i] + d;
}

__device__ float noise(uint32_t seed) {
  for (int round = 0; round < 3; ++round) {
    seed = seed * 1664525u + 1013904223u;
    seed ^= seed >> 15;
  }
  return static_cast<float>(seed) * 0x1p-32f - 0.5f;
}

// Three columns of noise that leave no eigenvector out.
__global__ void start_kernel(Depth depth, float4* eigenvector, Schwarz::Spectrum* spectrum) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= depth.topology.corner_count) return;
  if (i == 0) *spectrum = {0, 1, 0, 0, 0};
  const auto seed = static_cast<uint32_t>(3 * i);
  eigenvector[i] =
      sqrtf(depth.inverse_diagonal[i]) * float4{noise(seed), noise(seed + 1), noise(seed + 2), 0};
}

// x = M⁻¹S x from r = −S x, and the parts of x·Sx and M⁻¹Sx·Sx.
__global__ void power_kernel(Depth depth, Matrix inverse, const Schwarz::Spectrum* spectrum,
                             Sums<2>* partials) {
  await_previous();
  Sums<2> sums = {};
  for (int64_t i = thread_index(); i < depth.topology.corner_count; i += stride()) {
    const float4 x = depth.x[i], r = depth.r[i];
    const float4 next =
        -1 * product_row(depth.topology.rows, inverse, depth.r, static_cast<int32_t>(i));
    sums.at[0] -= sum_of(to_double(x) * to_double(r));
    sums.at[1] -= sum_of(to_double(next) * to_double(r));
    depth.x[i] = spectrum->normalise * next;
  }
  sums = block_sum(sums);
  if (threadIdx.x == 0) partials[blockIdx.x] = sums;
}

__device__ void set_steps(float lambda_max, Schwarz::Spectrum& spectrum) {
  const float centre = lambda_max * (1 + 1 / kSchwarzRange) / 2;
  const float half_width = lambda_max * (1 - 1 / kSchwarzRange) / 2;
  const float sigma = centre / half_width;
  const float rho = 1 / (2 * sigma - 1 / sigma);
  spectrum.first_step = 1 / centre;
  spectrum.momentum = rho / sigma;
  spectrum.second_step = 2 * rho / half_width;
}

__global__ void spectrum_kernel(const Sums<2>* partials, int count, const float* anisotropy,
                                Schwarz::Spectrum* spectrum) {
  await_previous();
  const Sums<2> total = total_of(partials, count);
  if (threadIdx.x != 0) return;
  if (total.at[0] > 0 && total.at[1] > 0) {
    spectrum->lambda_max = static_cast<float>(total.at[1] / total.at[0]);
    spectrum->normalise = static_cast<float>(1 / sqrt(total.at[1]));
  }
  const float estimate = static_cast<float>(kLambdaMaxMargin) * spectrum->lambda_max;
  set_steps(fminf(fmaxf(estimate, lambda_max_least(*anisotropy)), kLambdaMaxBound), *spectrum);
}

}  // namespace

Schwarz::Schwarz(Stream& stream, const Depth& depth)
    : stream_(stream),
      depth_(depth),
      entry_(stream, depth.topology.entry_count),
      diagonal_(stream, depth.topology.corner_count),
      direction_(stream, depth.topology.corner_count),
      eigenvector_(stream, depth.topology.corner_count),
      partials_(stream, kPartialsMax),
      spectrum_(stream, 1),
      inverse_{entry_.data(), diagonal_.data()} {}

void Schwarz::set_up(const CellSquares<float>& inverses, const float* anisotropy) {
  branch_.fork();
  invert_cells(branch_.stream(), depth_, inverses);
  assemble_inverse(branch_.stream(), depth_, inverses, inverse_);
  estimate_lambda_max(anisotropy);
}

void Schwarz::estimate_lambda_max(const float* anisotropy) {
  Stream& stream = branch_.stream();
  const int64_t n = depth_.topology.corner_count;
  Depth power = depth_;
  power.x = eigenvector_.data();
  if (first_) launch(stream, start_kernel, n, depth_, eigenvector_.data(), spectrum_.data());
  if (stream.is_ok())
    stream.check(cudaMemsetAsync(power.f, 0, n * sizeof(float4), stream.get()), "clearing f");
  for (int i = 0; i < (first_ ? kIterationsFirst : kIterationsNext); ++i) {
    compute_residual(stream, power);
    launch_striding(stream, power_kernel, n, power, inverse_, spectrum_.data(), partials_.data());
    launch_one_block(stream, spectrum_kernel, partials_.data(), partial_count(n), anisotropy,
                     spectrum_.data());
  }
  first_ = false;
}

void Schwarz::relax_from_zero() {
  const int32_t n = depth_.topology.corner_count;
  launch(stream_, step_kernel<Step::kFromZero>, n, depth_, inverse_, depth_.f, spectrum_.data(),
         direction_.data());
  compute_residual(stream_, depth_);
  launch(stream_, step_kernel<Step::kSecond>, n, depth_, inverse_, depth_.r, spectrum_.data(),
         direction_.data());
}

void Schwarz::relax() {
  const int32_t n = depth_.topology.corner_count;
  compute_residual(stream_, depth_);
  launch(stream_, step_kernel<Step::kFirst>, n, depth_, inverse_, depth_.r, spectrum_.data(),
         direction_.data());
  compute_residual(stream_, depth_);
  launch(stream_, step_kernel<Step::kSecond>, n, depth_, inverse_, depth_.r, spectrum_.data(),
         direction_.data());
}

uint64_t Schwarz::byte_count() const {
  return entry_.byte_count() + diagonal_.byte_count() + direction_.byte_count() +
         eigenvector_.byte_count() + partials_.byte_count() + spectrum_.byte_count();
}

}  // namespace burnish::cuda

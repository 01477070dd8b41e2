#include <algorithm>

#include "server/solver/cuda/cell_inverse.h"
#include "server/solver/cuda/products.h"
#include "server/solver/cuda/reduce.h"
#include "server/solver/cuda/schwarz.h"
#include "server/solver/cuda/transfer.h"
#include "server/solver/schwarz_bounds.h"

namespace burnish::cuda {

namespace {

constexpr int kIterationsFirst = 15;
constexpr int kIterationsNext = 1;

enum class Step { kFromZero, kSecondFromZero, kFirst, kSecond };

// d = momentum·d + length·M⁻¹ source; x += d, or x = d from zero, where d need not be kept.
template <Step kStep>
__global__ void __launch_bounds__(kThreads, 8)
    step_kernel(Depth depth, Matrix inverse, const float4* source,
                const Schwarz::Spectrum* spectrum, float4* direction) {
  float4* tile = tile_of_block<float4>();
  let_next_start();
  constexpr bool kIsSecond = kStep == Step::kSecond || kStep == Step::kSecondFromZero;
  const FetchedRow row = fetch_row(depth.topology.rows, inverse.packed, blockIdx.x);
  const int32_t i = row.corner;
  const float diagonal = i >= 0 ? inverse.diagonal[i] : 0;
  const float momentum = spectrum->momentum;
  const float length = kIsSecond ? spectrum->second_step : spectrum->first_step;
  await_previous();
  float4 x = zero4(), last = zero4();
  if (kStep != Step::kFromZero && i >= 0) x = depth.x[i];
  if (kStep == Step::kSecond && i >= 0) last = direction[i];
  if (kStep == Step::kSecondFromZero) last = x;
  fill_tile(row, source, tile);
  if (i < 0) return;
  float4 d = length * (diagonal * tile[threadIdx.x] + product_of(row, tile));
  if (kIsSecond) d = momentum * last + d;
  if (kStep == Step::kFirst) direction[i] = d;
  depth.x[i] = x + d;
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

__device__ void set_steps(float lambda_max, Schwarz::Spectrum& spectrum) {
  const float centre = lambda_max * (1 + 1 / kSchwarzRange) / 2;
  const float half_width = lambda_max * (1 - 1 / kSchwarzRange) / 2;
  const float sigma = centre / half_width;
  const float rho = 1 / (2 * sigma - 1 / sigma);
  spectrum.first_step = 1 / centre;
  spectrum.momentum = rho / sigma;
  spectrum.second_step = 2 * rho / half_width;
}

__device__ void update_spectrum(const Sums<2>& total, float anisotropy,
                                Schwarz::Spectrum& spectrum) {
  if (total.at[0] > 0 && total.at[1] > 0) {
    spectrum.lambda_max = static_cast<float>(total.at[1] / total.at[0]);
    spectrum.normalise = static_cast<float>(1 / sqrt(total.at[1]));
  }
  const float estimate = static_cast<float>(kLambdaMaxMargin) * spectrum.lambda_max;
  set_steps(fminf(fmaxf(estimate, lambda_max_least(anisotropy)), kLambdaMaxBound), spectrum);
}

// x = M⁻¹S x from r = −S x, and the sums x·Sx and M⁻¹Sx·Sx, which the last block makes the steps
// of.
__global__ void power_kernel(Depth depth, Matrix inverse, const float* anisotropy,
                             Schwarz::Spectrum* spectrum, Partials<2> partials) {
  float4* tile = tile_of_block<float4>();
  Sums<2> sums = {};
  await_previous();
  const float normalise = spectrum->normalise;
  for (int g = static_cast<int>(blockIdx.x); g < depth.topology.rows.group_count;
       g += static_cast<int>(gridDim.x)) {
    const FetchedRow row = fetch_row(depth.topology.rows, inverse.packed, g);
    const int32_t i = row.corner;
    fill_tile(row, depth.r, tile);
    if (i >= 0) {
      const float4 x = depth.x[i], r = tile[threadIdx.x];
      const float4 next = -1 * (inverse.diagonal[i] * r + product_of(row, tile));
      sums.at[0] -= sum_of(to_double(x) * to_double(r));
      sums.at[1] -= sum_of(to_double(next) * to_double(r));
      depth.x[i] = normalise * next;
    }
    __syncthreads();
  }
  Sums<2> total;
  if (add_up(sums, partials, &total)) update_spectrum(total, *anisotropy, *spectrum);
}

}  // namespace

Schwarz::Schwarz(Stream& stream, const Depth& depth)
    : stream_(stream),
      depth_(depth),
      packed_(stream, depth.topology.entry_count),
      diagonal_(stream, depth.topology.corner_count),
      direction_(stream, depth.topology.corner_count),
      eigenvector_(stream, depth.topology.corner_count),
      sums_(stream, kPartialsMax),
      arrived_(stream, 1),
      spectrum_(stream, 1),
      inverse_{packed_.data(), diagonal_.data()} {}

Stream& Schwarz::fork() {
  branch_.fork();
  return branch_.stream();
}

void Schwarz::set_up(const CellSquares<float>& inverses, const float* anisotropy) {
  invert_cells(branch_.stream(), depth_, inverses);
  assemble_inverse(branch_.stream(), depth_, inverses, inverse_);
  estimate_lambda_max(anisotropy);
}

void Schwarz::estimate_lambda_max(const float* anisotropy) {
  Stream& stream = branch_.stream();
  const Rows& rows = depth_.topology.rows;
  Depth power = depth_;
  power.x = eigenvector_.data();
  if (first_)
    launch(stream, start_kernel, rows.count, depth_, eigenvector_.data(), spectrum_.data());
  // A memset, which also keeps the products from fetching rows before they are there.
  if (stream.is_ok())
    stream.check(cudaMemsetAsync(power.f, 0, rows.count * sizeof(float4), stream.get()),
                 "clearing f");
  for (int i = 0; i < (first_ ? kIterationsFirst : kIterationsNext); ++i) {
    compute_residual(stream, power);
    launch_products<float4>(stream, power_kernel, rows, std::min(rows.group_count, kPartialsMax),
                            power, inverse_, anisotropy, spectrum_.data(),
                            Partials<2>{sums_.data(), arrived_.data()});
  }
  first_ = false;
}

void Schwarz::relax_from_zero() {
  const Rows& rows = depth_.topology.rows;
  launch_products<float4>(stream_, step_kernel<Step::kFromZero>, rows, rows.group_count, depth_,
                          inverse_, depth_.f, spectrum_.data(), nullptr);
  compute_residual(stream_, depth_);
  launch_products<float4>(stream_, step_kernel<Step::kSecondFromZero>, rows, rows.group_count,
                          depth_, inverse_, depth_.r, spectrum_.data(), nullptr);
}

void Schwarz::relax() {
  const Rows& rows = depth_.topology.rows;
  compute_residual(stream_, depth_);
  launch_products<float4>(stream_, step_kernel<Step::kFirst>, rows, rows.group_count, depth_,
                          inverse_, depth_.r, spectrum_.data(), direction_.data());
  compute_residual(stream_, depth_);
  launch_products<float4>(stream_, step_kernel<Step::kSecond>, rows, rows.group_count, depth_,
                          inverse_, depth_.r, spectrum_.data(), direction_.data());
}

uint64_t Schwarz::byte_count() const {
  return packed_.byte_count() + diagonal_.byte_count() + direction_.byte_count() +
         eigenvector_.byte_count() + sums_.byte_count() + spectrum_.byte_count();
}

}  // namespace burnish::cuda

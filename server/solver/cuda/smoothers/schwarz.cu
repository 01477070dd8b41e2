#include <algorithm>

#include "server/solver/cuda/device/read_bits.h"
#include "server/solver/cuda/halo.h"
#include "server/solver/cuda/products/long_products.h"
#include "server/solver/cuda/products/transfer.h"
#include "server/solver/cuda/smoothers/cell_inverse.h"
#include "server/solver/cuda/smoothers/power_step.h"
#include "server/solver/cuda/smoothers/schwarz.h"

namespace burnish::cuda {

namespace {

constexpr int kIterationsFirst = 15;  // each later matrix takes one

enum class Step { kFromZero, kSecondFromZero, kFirst, kSecond };

// Does d = momentum·d + length·M⁻¹ source; x += d, or x = d from zero without keeping d.
template <Step kStep, bool kLong, bool kRests>
__global__ void __launch_bounds__(kThreads, kLong ? 6 : 8)
    step_kernel(Depth depth, Matrix inverse, const float4* source, const Spectrum* spectrum,
                float4* direction) {
  float4* tile = tile_of_block<float4>();
  let_next_start();
  constexpr bool kIsSecond = kStep == Step::kSecond || kStep == Step::kSecondFromZero;
  const FetchedRow row = fetch_row(depth.topology.rows, inverse.packed, blockIdx.x);
  LongPart<kLong> beyond(depth.topology.rows.long_rows, inverse.long_entries, row);
  const int32_t i = row.corner;
  const float diagonal = i >= 0 ? inverse.diagonal[i] : 0;
  const float momentum = spectrum->momentum;
  const float length = kIsSecond ? spectrum->second_step : spectrum->first_step;
  await_previous();
  float4 x = zero4(), last = zero4();
  if (kStep != Step::kFromZero && i >= 0) x = depth.x[i];
  if (kStep == Step::kSecond && i >= 0) last = direction[i];
  if (kStep == Step::kSecondFromZero) last = x;
  beyond.start(source);
  fill_tile(row, source, tile);
  beyond.finish(source);
  if (i < 0) return;
  float4 product = diagonal * tile[threadIdx.x] + beyond.added_to(product_of(row, tile));
  if (kRests) product = product + rest_of_product(inverse.rest, row, tile);
  float4 d = length * product;
  if (kIsSecond) d = momentum * last + d;
  if (kStep == Step::kFirst) direction[i] = d;
  depth.x[i] = x + d;
}

// Rests exist at the finest depth, which has no long rows.
template <Step kStep>
auto* kernel_of(const Rows& rows, const Matrix& inverse) {
  if (inverse.rest != nullptr) return step_kernel<kStep, false, true>;
  return has_long(rows) ? step_kernel<kStep, true, false> : step_kernel<kStep, false, false>;
}

__device__ float noise(uint32_t seed) {
  for (int round = 0; round < 3; ++round) {
    seed = seed * 1664525u + 1013904223u;
    seed ^= seed >> 15;
  }
  return static_cast<float>(seed) * 0x1p-32f - 0.5f;
}

// Sets three columns of noise, which leave no eigenvector out.
__global__ void start_kernel(Depth depth, float4* eigenvector, Spectrum* spectrum) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= depth.topology.corner_count) return;
  if (i == 0) *spectrum = {0, 1, 0, 0, 0};
  const auto seed = static_cast<uint32_t>(3 * i);
  eigenvector[i] =
      sqrtf(depth.inverse_diagonal[i]) * float4{noise(seed), noise(seed + 1), noise(seed + 2), 0};
}

template <bool kLong>
__global__ void power_kernel(Depth depth, Matrix inverse, PowerStep power) {
  float4* tile = tile_of_block<float4>();
  await_previous();
  const FetchedRow row = fetch_row(depth.topology.rows, inverse.packed, blockIdx.x);
  LongPart<kLong> beyond(depth.topology.rows.long_rows, inverse.long_entries, row);
  beyond.start(power.product);
  fill_tile(row, power.product, tile);
  beyond.finish(power.product);
  Sums<2> sums = {};
  if (const int32_t i = row.corner; i >= 0) {
    // The tile holds the residual −S x.
    const float4 product = -1 * tile[threadIdx.x];
    float4 off_diagonal = beyond.added_to(product_of(row, tile));
    if (inverse.rest != nullptr)
      off_diagonal = off_diagonal + rest_of_product(inverse.rest, row, tile);
    const float4 next = inverse.diagonal[i] * product + -1 * off_diagonal;
    replace(power, i, next, product, power.spectrum->normalise, sums);
  }
  update_spectrum(power, sums);
}

__global__ void finish_kernel(PowerStep power, OfShards of_shards) {
  if (thread_index() == 0) finish_spectrum(power, sum_of<2>(of_shards));
}

__global__ void renew_steps_kernel(const float* anisotropy, Spectrum* spectrum) {
  await_previous();
  renew_steps(*anisotropy, *spectrum);
}

}  // namespace

Schwarz::Schwarz(Stream& stream, const Depth& depth, bool with_rests, Halo* halo, int number)
    : stream_(stream),
      depth_(depth),
      packed_(stream, depth.topology.entry_count),
      long_entries_(stream, depth.topology.rows.long_rows.entry_count),
      rest_(stream, with_rests ? depth.topology.entry_count : 0),
      diagonal_(stream, depth.topology.corner_count),
      direction_(stream, depth.topology.corner_count),
      eigenvector_(stream, depth.topology.corner_count),
      sums_(stream, depth.topology.rows.group_count),
      arrived_(stream, 1),
      spectrum_(stream, 1),
      totals_(stream, halo != nullptr ? OfShards::kTotals : 0),
      inverse_{packed_.data(), diagonal_.data(), long_entries_.data(), rest_.data()},
      halo_(halo),
      number_(number) {}

Stream& Schwarz::fork() {
  branch_.fork();
  return branch_.stream();
}

PowerStep Schwarz::power_step(const float* anisotropy) const {
  return {eigenvector_.data(),
          depth_.r,
          anisotropy,
          spectrum_.data(),
          {sums_.data(), arrived_.data()},
          depth_.topology.own_count,
          totals_.data()};
}

void Schwarz::set_up(const CellSquares<float>& inverses, const float* anisotropy) {
  const PowerStep power = power_step(anisotropy);
  if (halo_ != nullptr) halo_->refresh(branch_.stream(), number_, depth_.inverse_diagonal);
  refresh(branch_.stream(), depth_.r);
  invert_cells(branch_.stream(), depth_, inverses, inverse_.rest != nullptr, is_careful_, {});
  assemble_inverse(branch_.stream(), depth_, inverses, inverse_, power, direction_.data(), {});
  finish_iteration(power);
  if (first_) start_estimate(power);
  first_ = false;
}

// An iteration takes as long as all of M⁻¹, and hardly leaves the last metric's eigenvector. So the
// estimate stays until the next whole metric, and its least value follows the cells.
void Schwarz::update(const CellSquares<float>& inverses, const float* anisotropy,
                     const Touched& touched) {
  Stream& stream = branch_.stream();
  invert_cells(stream, depth_, inverses, inverse_.rest != nullptr, is_careful_, touched.inverses);
  assemble_inverse(stream, depth_, inverses, inverse_, power_step(anisotropy), direction_.data(),
                   touched.inverse_rows);
  launch_blocks(stream, renew_steps_kernel, dim3(1), dim3(1), 0, anisotropy, spectrum_.data());
}

// Without other shards the kernels have done it.
void Schwarz::finish_iteration(const PowerStep& power) {
  if (halo_ == nullptr) return;
  const OfShards all = halo_->share(branch_.stream(), number_, power.totals);
  launch_whole(branch_.stream(), finish_kernel, 1, power, all);
  refresh(branch_.stream(), power.x);
}

void Schwarz::refresh(Stream& stream, float4* vector) {
  if (halo_ != nullptr) halo_->refresh(stream, number_, vector);
}

void Schwarz::start_estimate(const PowerStep& power) {
  Stream& stream = branch_.stream();
  const Rows& rows = depth_.topology.rows;
  Depth depth = depth_;
  depth.x = power.x;
  launch(stream, start_kernel, rows.count, depth_, power.x, power.spectrum);
  refresh(stream, power.x);
  // Uses a memset, which also keeps the products from fetching rows too early.
  if (stream.is_ok())
    stream.check(cudaMemsetAsync(depth.f, 0, rows.count * sizeof(float4), stream.get()),
                 "clearing f");
  for (int i = 0; i < kIterationsFirst; ++i) {
    compute_residual(stream, depth);
    refresh(stream, depth.r);
    launch_products<float4>(stream, has_long(rows) ? power_kernel<true> : power_kernel<false>, rows,
                            rows.own_group_count, depth, inverse_, power);
    finish_iteration(power);
  }
}

template <typename Kernel>
void Schwarz::step(Kernel kernel, const float4* source) {
  const Rows& rows = depth_.topology.rows;
  launch_products<float4>(stream_, kernel, rows, rows.own_group_count, depth_, inverse_, source,
                          spectrum_.data(), direction_.data());
}

void Schwarz::relax_from_zero() {
  const Rows& rows = depth_.topology.rows;
  step(kernel_of<Step::kFromZero>(rows, inverse_), depth_.f);
  refresh(stream_, depth_.x);
  compute_residual(stream_, depth_);
  refresh(stream_, depth_.r);
  step(kernel_of<Step::kSecondFromZero>(rows, inverse_), depth_.r);
  refresh(stream_, depth_.x);
}

void Schwarz::relax() {
  const Rows& rows = depth_.topology.rows;
  compute_residual(stream_, depth_);
  refresh(stream_, depth_.r);
  step(kernel_of<Step::kFirst>(rows, inverse_), depth_.r);
  refresh(stream_, depth_.x);
  compute_residual(stream_, depth_);
  refresh(stream_, depth_.r);
  step(kernel_of<Step::kSecond>(rows, inverse_), depth_.r);
  refresh(stream_, depth_.x);
}

void Schwarz::read(const std::string& name, std::vector<NamedBits>& to) {
  read_bits(stream_, name + ": inverse M", packed_, to);
  read_bits(stream_, name + ": rests of inverse M", rest_, to);
  read_bits(stream_, name + ": long rows of inverse M", long_entries_, to);
  read_bits(stream_, name + ": diagonal of inverse M", diagonal_, to);
}

uint64_t Schwarz::byte_count() const {
  return packed_.byte_count() + long_entries_.byte_count() + rest_.byte_count() +
         diagonal_.byte_count() + direction_.byte_count() + eigenvector_.byte_count() +
         sums_.byte_count() + spectrum_.byte_count();
}

}  // namespace burnish::cuda

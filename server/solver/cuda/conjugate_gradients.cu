#include "server/solver/cuda/conjugate_gradients.h"
#include "server/solver/cuda/reduce.h"

namespace burnish::cuda {

namespace {

using Vectors = ConjugateGradients::Vectors;
using Scalars = ConjugateGradients::Scalars;

constexpr int kSumsMax = 6;  // per column: two dot products

template <int kCount>
__device__ Sums<kCount>* partials_of(const Vectors& v) {
  return reinterpret_cast<Sums<kCount>*>(v.partials);
}

__device__ void add(Double3 a, double* sums) {
  sums[0] += a.x;
  sums[1] += a.y;
  sums[2] += a.z;
}

__device__ Double3 triple(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2], 0};
}

// A column that has nothing left to do has a zero divisor and takes a zero step.
__device__ double quotient(double dividend, double divisor) {
  return divisor > 0 ? dividend / divisor : 0;
}

__global__ void recompute_residual_kernel(Vectors v) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= v.finest.topology.corner_count) return;
  if (v.finest.inverse_diagonal[i] == 0)
    v.u[i] = v.r[i] = Double3{0, 0, 0, 0};
  else
    v.r[i] = v.b[i] - product_row(v.finest.topology.rows, v.matrix, v.u, static_cast<int32_t>(i));
}

__global__ void load_residual_kernel(Vectors v) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= v.finest.topology.corner_count) return;
  const Double3 r = v.r[i];
  v.finest.f[i] = {static_cast<float>(r.x), static_cast<float>(r.y), static_cast<float>(r.z), 0};
}

// z·r and z·q, z being the V-cycle's correction.
__global__ void correction_sums_kernel(Vectors v) {
  await_previous();
  Sums<6> sums = {};
  for (int64_t i = thread_index(); i < v.finest.topology.corner_count; i += stride()) {
    const Double3 z = to_double(v.finest.x[i]);
    add(z * v.r[i], sums.at);
    add(z * v.q[i], sums.at + 3);
  }
  sums = block_sum(sums);
  if (threadIdx.x == 0) partials_of<6>(v)[blockIdx.x] = sums;
}

__global__ void momentum_kernel(Vectors v, int count, bool restart) {
  await_previous();
  const Sums<6> total = total_of(partials_of<6>(v), count);
  if (threadIdx.x != 0) return;
  Scalars& scalars = *v.scalars;
  for (int n = 0; n < 3; ++n) {
    const double change = -scalars.step[n] * total.at[3 + n];
    scalars.momentum[n] = restart ? 0 : quotient(change, scalars.z_dot_r[n]);
    scalars.z_dot_r[n] = total.at[n];
  }
  scalars.correction_squared_max = 0;
}

__global__ void direction_kernel(Vectors v) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= v.finest.topology.corner_count) return;
  v.p[i] = to_double(v.finest.x[i]) + triple(v.scalars->momentum) * v.p[i];
}

__device__ float squared_correction(const Depth& finest, const VertexPlace& place) {
  float4 moved = zero4();
  for (int a = 0; a < 8; ++a) {
    float weight = 1;
    for (int axis = 0; axis < 3; ++axis)
      weight *= a >> axis & 1 ? place.local[axis] : 1 - place.local[axis];
    moved = moved + weight * finest.x[finest.topology.cell_corners[place.cell].at[a]];
  }
  return moved.x * moved.x + moved.y * moved.y + moved.z * moved.z;
}

// Numbers that are not negative compare as their bits do, and a largest has no order.
__global__ void largest_correction_kernel(Vectors v, const VertexPlace* places, int64_t count) {
  await_previous();
  float most = 0;
  for (int64_t i = thread_index(); i < count; i += stride())
    if (places[i].cell >= 0) most = fmaxf(most, squared_correction(v.finest, places[i]));
  for (int offset = 16; offset > 0; offset /= 2)
    most = fmaxf(most, __shfl_down_sync(0xffffffffu, most, offset));
  if (threadIdx.x % 32 == 0)
    atomicMax(reinterpret_cast<unsigned*>(&v.scalars->correction_squared_max),
              __float_as_uint(most));
}

// q = S p, and the parts of p·q and p·r.
__global__ void product_kernel(Vectors v) {
  await_previous();
  Sums<6> sums = {};
  for (int64_t i = thread_index(); i < v.finest.topology.corner_count; i += stride()) {
    Double3 q = {0, 0, 0, 0};
    if (v.finest.inverse_diagonal[i] != 0)
      q = product_row(v.finest.topology.rows, v.matrix, v.p, static_cast<int32_t>(i));
    v.q[i] = q;
    add(v.p[i] * q, sums.at);
    add(v.p[i] * v.r[i], sums.at + 3);
  }
  sums = block_sum(sums);
  if (threadIdx.x == 0) partials_of<6>(v)[blockIdx.x] = sums;
}

__global__ void step_length_kernel(Vectors v, int count) {
  await_previous();
  const Sums<6> total = total_of(partials_of<6>(v), count);
  if (threadIdx.x != 0) return;
  for (int n = 0; n < 3; ++n) v.scalars->step[n] = quotient(total.at[3 + n], total.at[n]);
}

// u and r after the step, and the parts of their measures.
__global__ void advance_kernel(Vectors v) {
  await_previous();
  Sums<3> sums = {};
  const Double3 step = triple(v.scalars->step);
  for (int64_t i = thread_index(); i < v.finest.topology.corner_count; i += stride()) {
    const Double3 b = v.b[i], u = v.u[i] + step * v.p[i], r = v.r[i] - step * v.q[i];
    v.u[i] = u;
    v.r[i] = r;
    const double scale = v.finest.inverse_diagonal[i];
    sums.at[0] -= 0.5 * sum_of(u * (b + r));
    sums.at[1] += scale * sum_of(r * r);
    sums.at[2] += scale * sum_of(b * b);
  }
  sums = block_sum(sums);
  if (threadIdx.x == 0) partials_of<3>(v)[blockIdx.x] = sums;
}

__global__ void measures_kernel(Vectors v, int count) {
  await_previous();
  const Sums<3> total = total_of(partials_of<3>(v), count);
  if (threadIdx.x != 0) return;
  v.scalars->energy = total.at[0];
  v.scalars->residual = total.at[1];
  v.scalars->constraint = total.at[2];
}

}  // namespace

ConjugateGradients::ConjugateGradients(Stream& stream, const Depth& finest,
                                       const VertexPlace* evaluation, size_t vertex_count)
    : stream_(stream),
      n_(finest.topology.corner_count),
      evaluation_(evaluation),
      vertex_count_(static_cast<int64_t>(vertex_count)),
      entry_(stream, finest.topology.entry_count),
      row_sum_(stream, n_),
      partials_(stream, kPartialsMax * kSumsMax),
      u_(stream, n_),
      b_(stream, n_),
      r_(stream, n_),
      p_(stream, n_),
      q_(stream, n_),
      scalars_(stream, 1),
      vectors_{finest,         {entry_.data(), row_sum_.data()},
               u_.data(),      b_.data(),
               r_.data(),      p_.data(),
               q_.data(),      partials_.data(),
               scalars_.data()} {}

void ConjugateGradients::recompute_residual() {
  launch(stream_, recompute_residual_kernel, n_, vectors_);
}

void ConjugateGradients::load_residual() {
  launch(stream_, load_residual_kernel, n_, vectors_);
}

void ConjugateGradients::update_direction(bool restart) {
  launch_striding(stream_, correction_sums_kernel, n_, vectors_);
  launch_one_block(stream_, momentum_kernel, vectors_, partial_count(n_), restart);
  launch_striding(stream_, largest_correction_kernel, vertex_count_, vectors_, evaluation_,
                  vertex_count_);
  launch(stream_, direction_kernel, n_, vectors_);
}

void ConjugateGradients::advance() {
  launch_striding(stream_, product_kernel, n_, vectors_);
  launch_one_block(stream_, step_length_kernel, vectors_, partial_count(n_));
  launch_striding(stream_, advance_kernel, n_, vectors_);
  launch_one_block(stream_, measures_kernel, vectors_, partial_count(n_));
}

ConjugateGradients::Scalars ConjugateGradients::measure() const {
  Scalars scalars = {};
  scalars_.download(stream_, {&scalars, 1});
  return scalars;
}

uint64_t ConjugateGradients::byte_count() const {
  return entry_.byte_count() + row_sum_.byte_count() + partials_.byte_count() +
         5 * u_.byte_count() + scalars_.byte_count();
}

}  // namespace burnish::cuda

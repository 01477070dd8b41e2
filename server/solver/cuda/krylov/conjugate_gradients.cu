#include <algorithm>

#include "server/solver/cuda/device/reduce.h"
#include "server/solver/cuda/halo.h"
#include "server/solver/cuda/krylov/conjugate_gradients.h"
#include "server/solver/cuda/products/products.h"

namespace burnish::cuda {

namespace {

using Vectors = ConjugateGradients::Vectors;
using Scalars = ConjugateGradients::Scalars;

__device__ void add(Double3 a, double* sums) {
  sums[0] += a.x;
  sums[1] += a.y;
  sums[2] += a.z;
}

__device__ Double3 triple(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

__device__ ExactMatrix exact_matrix(const Vectors& v) {
  return {v.finest.system.packed, v.finest.system.rest, v.finest.remainder, v.row_sum};
}

__device__ Double3 constraint_of(const Vectors& v, int64_t i) {
  if (v.finest.inverse_diagonal[i] == 0) return {0, 0, 0};
  const Double3 of_slider = *v.b.slider_less_one * v.b.per_slider[i];
  return v.b.is_painted[i / kSliceRows] ? of_slider + v.b.own[i] : of_slider;
}

// A column that is solved has a zero divisor; its step is zero.
__device__ double quotient(double dividend, double divisor) {
  return divisor > 0 ? dividend / divisor : 0;
}

template <bool kRemainder>
__global__ void recompute_residual_kernel(Vectors v) {
  Double3* tile = tile_of_block<Double3>();
  await_previous();
  const FetchedRow row = fetch_row(v.finest.topology.rows, v.finest.system.packed, blockIdx.x);
  const int32_t i = row.corner;
  fill_tile(row, v.u, tile);
  if (i < 0) return;
  Double3 r = {0, 0, 0};
  if (v.finest.inverse_diagonal[i] != 0)
    r = constraint_of(v, i) - product_of<kRemainder>(row, exact_matrix(v), tile);
  v.r[i] = r;
  v.finest.f[i] = to_float(r);
}

__global__ void pin_kernel(Vectors v) {
  await_previous();
  const int64_t i = thread_index();
  if (i < v.finest.topology.corner_count && v.finest.inverse_diagonal[i] == 0)
    v.u[i] = Double3{0, 0, 0};
}

// The energy ½a²u·Su − a u·b is least at a = u·b / u·Su.
__device__ void choose_scale(const Sums<9>& total, Scalars& scalars) {
  for (int n = 0; n < 3; ++n) scalars.scale[n] = quotient(total.at[n], total.at[3 + n]);
}

__global__ void finish_scale_kernel(Vectors v, OfShards of_shards) {
  if (thread_index() == 0) choose_scale(sum_of<9>(of_shards), *v.scalars);
}

// Sums u·b and u·Su; Su is b − r.
__global__ void scale_sums_kernel(Vectors v) {
  await_previous();
  Sums<9> sums = {};
  for (int64_t i = thread_index(); i < v.finest.topology.own_count; i += stride()) {
    const Double3 u = v.u[i], b = constraint_of(v, i);
    add(u * b, sums.at);
    add(u * (b - v.r[i]), sums.at + 3);
  }
  Sums<9> total;
  if (!add_up(sums, v.products, &total)) return;
  if (v.totals != nullptr)
    tell(total, v.totals);
  else
    choose_scale(total, *v.scalars);
}

__global__ void rescale_kernel(Vectors v) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= v.finest.topology.corner_count) return;
  const Double3 scale = triple(v.scalars->scale), b = constraint_of(v, i),
                r = b - scale * (b - v.r[i]);
  v.u[i] = scale * v.u[i];
  v.r[i] = r;
  v.finest.f[i] = to_float(r);
}

// Computes the products of p = z + m p' with q and r from the last sums of p'. Exact conjugacy of p
// to p', and of r to p', would need fewer sums. But they hold only to rounding. A step that relies
// on them is no longer the one of least energy once only rounding is left to correct.
__device__ void choose_step(const Sums<9>& products, bool restart, Scalars& scalars) {
  for (int n = 0; n < 3; ++n) {
    const double z_dot_r = products.at[n], z_dot_q = products.at[3 + n],
                 z_dot_w = products.at[6 + n], last_p_dot_q = scalars.p_dot_q[n];
    const double momentum = restart ? 0 : quotient(-z_dot_q, last_p_dot_q);
    const double p_dot_q = z_dot_w + momentum * (2 * z_dot_q + momentum * last_p_dot_q);
    const bool is_sound = p_dot_q > 0;  // else only rounding is left
    scalars.momentum[n] = is_sound ? momentum : 0;
    scalars.z_dot_r[n] = z_dot_r;
    scalars.step[n] =
        quotient(z_dot_r + scalars.momentum[n] * scalars.p_dot_r[n], is_sound ? p_dot_q : z_dot_w);
  }
}

__global__ void finish_step_kernel(Vectors v, bool restart, OfShards of_shards) {
  if (thread_index() == 0) choose_step(sum_of<9>(of_shards), restart, *v.scalars);
}

// Makes w = S z, z·r, z·q and z·w.
template <bool kRemainder>
__global__ void __launch_bounds__(kThreads, 6) product_kernel(Vectors v, bool restart) {
  float4* tile = tile_of_block<float4>();
  let_next_start();
  const Rows& rows = v.finest.topology.rows;
  Sums<9> sums = {};
  for (int g = static_cast<int>(blockIdx.x); g < rows.own_group_count;
       g += static_cast<int>(gridDim.x)) {
    const FetchedRow row = fetch_row(rows, v.finest.system.packed, g);
    const int32_t i = row.corner;
    const bool is_free = i >= 0 && v.finest.inverse_diagonal[i] != 0;
    await_previous();
    fill_tile(row, v.finest.x, tile);
    if (i >= 0) {
      const Double3 z = to_double(tile[threadIdx.x]);
      Double3 w = {0, 0, 0};
      if (is_free) w = product_of<kRemainder>(row, exact_matrix(v), tile);
      v.w[i] = w;
      if (i < v.finest.topology.own_count) {
        add(z * v.r[i], sums.at);
        add(z * v.q[i], sums.at + 3);
        add(z * w, sums.at + 6);
      }
    }
    __syncthreads();
  }
  Sums<9> total;
  if (!add_up(sums, v.products, &total)) return;
  if (v.totals != nullptr)
    tell(total, v.totals);
  else
    choose_step(total, restart, *v.scalars);
}

// Makes E z at every vertex.
__global__ void evaluate_correction_kernel(Vectors v, const VertexPlace* places) {
  await_previous();
  for (int64_t i = thread_index(); i < v.vertex_count; i += stride()) {
    const VertexPlace place = places[i];
    float4 sum = zero4();
    for (int a = 0; a < 8 && place.cell >= 0; ++a) {
      float weight = 1;
      for (int axis = 0; axis < 3; ++axis)
        weight *= a >> axis & 1 ? place.local[axis] : 1 - place.local[axis];
      sum = sum + weight * v.finest.x[v.finest.topology.cell_corners[place.cell].at[a]];
    }
    v.vertex_z[i] = sum;
  }
}

// Makes E p at every vertex after the step, and the largest E a p. Numbers that are not negative
// compare like their bits, and a maximum does not depend on the order.
__device__ void move_vertices(const Vectors& v, const Double3& step, const Double3& momentum) {
  float most = 0;
  for (int64_t i = thread_index(); i < v.vertex_count; i += stride()) {
    const Double3 p = to_double(v.vertex_z[i]) + momentum * to_double(v.vertex_p[i]);
    const Double3 moved = step * p;
    v.vertex_p[i] = to_float(p);
    most = fmaxf(most, static_cast<float>(sum_of(moved * moved)));
  }
  for (int offset = 16; offset > 0; offset /= 2)
    most = fmaxf(most, __shfl_xor_sync(0xffffffffu, most, offset));
  if (threadIdx.x % 32 == 0)
    atomicMax(reinterpret_cast<unsigned*>(&v.scalars->moved_squared_max), __float_as_uint(most));
}

__device__ void keep_measures(const Sums<9>& total, float moved_squared_max, const Vectors& v) {
  Scalars& scalars = *v.scalars;
  scalars.energy = total.at[0];
  scalars.residual = total.at[1];
  scalars.constraint = total.at[2];
  for (int n = 0; n < 3; ++n) {
    scalars.p_dot_q[n] = total.at[3 + n];
    scalars.p_dot_r[n] = total.at[6 + n];
  }
  Scalars measured = scalars;
  measured.moved_squared_max = moved_squared_max;
  *v.measured = measured;
}

__global__ void finish_advance_kernel(Vectors v, OfShards of_shards) {
  if (thread_index() > 0) return;
  double most = 0;
  for (int shard = 0; shard < of_shards.count; ++shard)
    most = fmax(most, of_shards.totals[shard][9]);
  keep_measures(sum_of<9>(of_shards), static_cast<float>(most), v);
}

// Makes p, q, u and r after the step, the sums of p for the next step, and the parts of the
// measures.
__global__ void advance_kernel(Vectors v) {
  await_previous();
  Sums<9> sums = {};
  const Double3 step = triple(v.scalars->step), momentum = triple(v.scalars->momentum);
  for (int64_t i = thread_index(); i < v.finest.topology.corner_count; i += stride()) {
    const Double3 p = to_double(v.finest.x[i]) + momentum * v.p[i], q = v.w[i] + momentum * v.q[i];
    const Double3 b = constraint_of(v, i), u = v.u[i] + step * p, r = v.r[i] - step * q;
    v.p[i] = p;
    v.q[i] = q;
    v.u[i] = u;
    v.r[i] = r;
    v.finest.f[i] = to_float(r);
    if (i >= v.finest.topology.own_count) continue;
    const double scale = v.finest.inverse_diagonal[i];
    sums.at[0] -= 0.5 * sum_of(u * (b + r));
    sums.at[1] += scale * sum_of(r * r);
    sums.at[2] += scale * sum_of(b * b);
    add(p * q, sums.at + 3);
    add(p * r, sums.at + 6);
  }
  move_vertices(v, step, momentum);
  Sums<9> total;
  if (!add_up(sums, v.measures, &total)) return;
  const float moved_squared_max = __ldcg(&v.scalars->moved_squared_max);
  v.scalars->moved_squared_max = 0;
  if (v.totals != nullptr) {
    tell(total, v.totals);
    v.totals[9] = moved_squared_max;
  } else {
    keep_measures(total, moved_squared_max, v);
  }
}

}  // namespace

static size_t slice_count(int64_t corners) {
  return (corners + kSliceRows - 1) / kSliceRows;
}

ConjugateGradients::ConjugateGradients(Stream& stream, const Depth& finest,
                                       const VertexPlace* evaluation, size_t vertex_count,
                                       Halo* halo, int number)
    : stream_(stream),
      n_(finest.topology.corner_count),
      evaluation_(evaluation),
      row_sum_(stream, n_),
      slider_less_one_(stream, 1),
      u_(stream, n_),
      b_per_slider_(stream, n_),
      b_own_(stream, n_),
      is_painted_(stream, slice_count(n_)),
      is_touched_(stream, slice_count(n_)),
      r_(stream, n_),
      p_(stream, n_),
      q_(stream, n_),
      w_(stream, n_),
      vertex_z_(stream, vertex_count),
      vertex_p_(stream, vertex_count),
      product_sums_(stream, kPartialsMax),
      measure_sums_(stream, kPartialsMax),
      arrived_(stream, 2),
      scalars_(stream, 1),
      measured_(stream, 1),
      totals_(stream, halo != nullptr ? OfShards::kTotals : 0),
      vectors_{finest,
               row_sum_.data(),
               u_.data(),
               r_.data(),
               p_.data(),
               q_.data(),
               w_.data(),
               {b_per_slider_.data(), b_own_.data(), slider_less_one_.data(), is_painted_.data(),
                is_touched_.data()},
               static_cast<int64_t>(vertex_count),
               vertex_z_.data(),
               vertex_p_.data(),
               {product_sums_.data(), arrived_.data()},
               {measure_sums_.data(), arrived_.data() + 1},
               scalars_.data(),
               measured_.data(),
               totals_.data()},
      halo_(halo),
      number_(number) {}

void ConjugateGradients::start_over() {
  for (const auto* vector : {&u_, &r_, &p_, &q_, &w_}) vector->clear(stream_);
  vertex_p_.clear(stream_);
  scalars_.clear(stream_);
}

void ConjugateGradients::recompute_residual() {
  launch(stream_, pin_kernel, n_, vectors_);
  const Rows& rows = vectors_.finest.topology.rows;
  const auto kernel = vectors_.finest.remainder != nullptr ? recompute_residual_kernel<true>
                                                           : recompute_residual_kernel<false>;
  launch_products<Double3>(stream_, kernel, rows, rows.own_group_count, vectors_);
  refresh_residual();
}

void ConjugateGradients::rescale() {
  launch_striding(stream_, scale_sums_kernel, n_, vectors_);
  if (halo_ != nullptr) launch_whole(stream_, finish_scale_kernel, 1, vectors_, totals_of_all());
  launch(stream_, rescale_kernel, n_, vectors_);
  refresh_residual();
}

void ConjugateGradients::refresh_residual() {
  if (halo_ != nullptr) halo_->refresh(stream_, number_, vectors_.finest.f);
}

OfShards ConjugateGradients::totals_of_all() {
  return halo_->share(stream_, halo_->slot_of_solver(), totals_.data());
}

void ConjugateGradients::update_direction(bool restart) {
  branch_.fork();
  launch_striding(branch_.stream(), evaluate_correction_kernel, vectors_.vertex_count, vectors_,
                  evaluation_);
  const Rows& rows = vectors_.finest.topology.rows;
  const auto kernel =
      vectors_.finest.remainder != nullptr ? product_kernel<true> : product_kernel<false>;
  launch_products<float4>(stream_, kernel, rows, std::min(rows.own_group_count, kPartialsMax),
                          vectors_, restart);
  branch_.join();
  if (halo_ != nullptr)
    launch_whole(stream_, finish_step_kernel, 1, vectors_, restart, totals_of_all());
}

void ConjugateGradients::advance() {
  launch_striding(stream_, advance_kernel, n_, vectors_);
  if (halo_ == nullptr) return;
  launch_whole(stream_, finish_advance_kernel, 1, vectors_, totals_of_all());
  refresh_residual();
}

ConjugateGradients::Scalars ConjugateGradients::measure() const {
  return stream_.synchronize() ? *measured_.data() : Scalars{};
}

uint64_t ConjugateGradients::byte_count() const {
  return row_sum_.byte_count() + 7 * u_.byte_count() + 2 * vertex_z_.byte_count() +
         product_sums_.byte_count() + measure_sums_.byte_count() + scalars_.byte_count();
}

}  // namespace burnish::cuda

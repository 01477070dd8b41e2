#include "server/solver/cpu/krylov/conjugate_gradients.h"

#include <cmath>

#include "common/base/blocks.h"
#include "server/solver/cpu/krylov/largest_move.h"
#include "server/solver/cpu/products/exact_product.h"

namespace burnish::cpu {

namespace {

struct Sums {
  Double3 first = Double3::Zero();
  Double3 second = Double3::Zero();

  Sums& operator+=(const Sums& other) {
    first += other.first;
    second += other.second;
    return *this;
  }
};
static_assert(sizeof(Sums) == 6 * sizeof(double));

// A column that is solved has a zero divisor; its step is zero.
Double3 quotient(const Double3& dividend, const Double3& divisor) {
  return (divisor > 0).select(dividend / divisor, Double3::Zero());
}

Double3 columns(const Float4& v) {
  return v.head<3>().cast<double>();
}

Float4 with_spare(const Double3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), 0};
}

}  // namespace

ConjugateGradients::ConjugateGradients(CpuDepth& finest, const PointsByCell& points)
    : finest_(finest), points_(points), matrix_(finest.topology.stencil) {
  start_over();
}

void ConjugateGradients::start_over() {
  for (auto* vector : {&b_, &r_}) vector->assign(finest_.corner_count(), Double3::Zero());
  forget_steps();
}

void ConjugateGradients::forget_steps() {
  for (auto* vector : {&u_, &q_}) vector->assign(finest_.corner_count(), Double3::Zero());
  p_.assign(finest_.corner_count(), Float4::Zero());
  z_dot_r_ = step_ = Double3::Zero();
  totals_ = {};
  moved_max_ = curvature_ = direction_energy_ = 0;
}

// Sums over blocks of all corners, and over all shards. `sum_block` leaves out corners that are not
// own ones.
template <typename Sum, typename SumBlock>
Sum ConjugateGradients::sum_over_all(SumBlock&& sum_block) const {
  Sum sum = ordered_sum<Sum>(finest_.corner_count(), sum_block);
  if (finest_.halo != nullptr)
    finest_.halo->sum({reinterpret_cast<double*>(&sum), sizeof sum / sizeof(double)});
  return sum;
}

template <typename Sum, typename SumBlock>
Sum ConjugateGradients::sum_over_own(SumBlock&& sum_block) const {
  return sum_over_all<Sum>(
      [&](int32_t begin, int32_t end) { return sum_block(begin, own_end(end)); });
}

void ConjugateGradients::recompute_residual() {
#pragma omp parallel for schedule(dynamic, kBlock)
  for (int32_t i = 0; i < finest_.corner_count(); ++i)
    if (finest_.inverse_diagonal[i] == 0) u_[i].setZero();
  for_each_block(finest_.corner_count(), [&](int32_t begin, int32_t end) {
    exact_product(finest_, matrix_, u_, r_, begin, end);
    for (int32_t i = begin; i < end; ++i) finest_.f[i] = with_spare(r_[i] = b_[i] - r_[i]);
  });
  finest_.refresh(finest_.f);
}

// The energy ½a²u·Su − a u·b is least at a = u·b / u·Su, and Su is b − r.
void ConjugateGradients::rescale() {
  const Sums sums = sum_over_own<Sums>([&](int32_t begin, int32_t end) {
    Sums sum;
    for (int32_t i = begin; i < end; ++i) {
      sum.first += u_[i] * b_[i];
      sum.second += u_[i] * (b_[i] - r_[i]);
    }
    return sum;
  });
  const Double3 factor = quotient(sums.first, sums.second);
#pragma omp parallel for schedule(dynamic, kBlock)
  for (int32_t i = 0; i < finest_.corner_count(); ++i) {
    u_[i] *= factor;
    r_[i] = b_[i] - factor * (b_[i] - r_[i]);
    finest_.f[i] = with_spare(r_[i]);
  }
  finest_.refresh(finest_.f);
}

void ConjugateGradients::load_residual() {
#pragma omp parallel for schedule(dynamic, kBlock)
  for (int32_t i = 0; i < finest_.corner_count(); ++i) finest_.f[i] = with_spare(r_[i]);
  finest_.refresh(finest_.f);
}

void ConjugateGradients::update_direction(bool restart) {
  const Sums sums = sum_over_own<Sums>([&](int32_t begin, int32_t end) {
    Sums sum;
    for (int32_t i = begin; i < end; ++i) {
      const Double3 z = columns(finest_.x[i]);
      sum.first += z * columns(finest_.f[i]);
      sum.second += z * q_[i];
    }
    return sum;
  });
  const Double3 momentum =
      restart ? Double3(Double3::Zero()) : quotient(-step_ * sums.second, z_dot_r_);
  z_dot_r_ = sums.first;
  const Float4 gamma = with_spare(momentum);
#pragma omp parallel for schedule(dynamic, kBlock)
  for (int32_t i = 0; i < finest_.corner_count(); ++i) p_[i] = finest_.x[i] + gamma * p_[i];
}

void ConjugateGradients::advance() {
  const Sums sums = sum_over_all<Sums>([&](int32_t begin, int32_t end) {
    exact_product(finest_, matrix_, p_, q_, begin, end);
    Sums sum;
    for (int32_t i = begin; i < own_end(end); ++i) {
      const Double3 p = columns(p_[i]);
      sum.first += p * q_[i];
      sum.second += p * r_[i];
    }
    return sum;
  });
  step_ = quotient(sums.second, sums.first);
  curvature_ = sums.first.minCoeff();
  direction_energy_ = sums.first.sum();
  totals_ =
      sum_over_all<Totals>([&](int32_t begin, int32_t end) { return move_along(begin, end); });
  finest_.refresh(finest_.f);
  moved_max_ = largest_move(finest_.topology.grid, points_, p_, with_spare(step_));
  if (finest_.halo != nullptr) finest_.halo->keep_largest(moved_max_);
}

// Does u += a p and r −= a q; f follows r. Takes the sums of measure() while the numbers are in
// cache.
ConjugateGradients::Totals ConjugateGradients::move_along(int32_t begin, int32_t end) {
  Totals sum;
  for (int32_t i = begin; i < end; ++i) {
    u_[i] += step_ * columns(p_[i]);
    r_[i] -= step_ * q_[i];
    finest_.f[i] = with_spare(r_[i]);
    const double scale = finest_.inverse_diagonal[i];
    if (scale == 0 || i >= finest_.topology.own_count()) continue;
    sum.energy -= 0.5 * (u_[i] * (b_[i] + r_[i])).sum();
    sum.residual += scale * r_[i].square().sum();
    sum.constraint += scale * b_[i].square().sum();
  }
  return sum;
}

Measures ConjugateGradients::measure() const {
  Measures measures;
  measures.energy = totals_.energy;
  measures.residual =
      totals_.constraint > 0 ? std::sqrt(totals_.residual / totals_.constraint) : 0.0;
  measures.preconditioned_residual = z_dot_r_.sum();
  measures.moved_max = moved_max_;
  measures.curvature = curvature_;
  measures.direction_energy = direction_energy_;
  return measures;
}

uint64_t ConjugateGradients::byte_count() const {
  return matrix_.byte_count() + bytes_of(u_) + bytes_of(b_) + bytes_of(r_) + bytes_of(p_) +
         bytes_of(q_);
}

}  // namespace burnish::cpu

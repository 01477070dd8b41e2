#include "server/solver/cpu/conjugate_gradients.h"

#include <cmath>

#include "server/solver/cpu/reduce.h"

namespace burnish::cpu {

namespace {

struct Sums {
  Double4 first = Double4::Zero();
  Double4 second = Double4::Zero();
  double most = 0;

  Sums& operator+=(const Sums& other) {
    first += other.first;
    second += other.second;
    most = std::max(most, other.most);
    return *this;
  }
};

// A column that has nothing left to do has a zero divisor and takes a zero step.
Double4 quotient(const Double4& dividend, const Double4& divisor) {
  return (divisor > 0).select(dividend / divisor, Double4::Zero());
}

}  // namespace

ConjugateGradients::ConjugateGradients(CpuDepth& finest, const std::vector<float>& visibility)
    : finest_(finest), visibility_(visibility) {
  for (auto* vector : {&u_, &b_, &r_, &p_, &q_})
    vector->assign(finest.corner_count(), Double4::Zero());
}

void ConjugateGradients::recompute_residual() {
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < finest_.corner_count(); ++i) {
    if (finest_.inverse_diagonal[i] == 0)
      u_[i] = r_[i] = Double4::Zero();
    else
      r_[i] = b_[i] - system_row(finest_, u_, i);
  }
}

void ConjugateGradients::load_residual() {
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < finest_.corner_count(); ++i) finest_.f[i] = r_[i].cast<float>();
}

void ConjugateGradients::update_direction(bool restart) {
  const Sums sums = ordered_sum<Sums>(finest_.corner_count(), [&](int32_t begin, int32_t end) {
    Sums sum;
    for (int32_t i = begin; i < end; ++i) {
      const Float4 z = finest_.x[i];
      sum.first += z.cast<double>() * r_[i];
      sum.second += z.cast<double>() * q_[i];
      const double length = z.head<3>().matrix().norm();
      sum.most = std::max(sum.most, visibility_[i] * length);
    }
    return sum;
  });
  correction_max_ = sums.most;
  const Double4 momentum =
      restart ? Double4(Double4::Zero()) : quotient(-step_ * sums.second, z_dot_r_);
  z_dot_r_ = sums.first;
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < finest_.corner_count(); ++i)
    p_[i] = finest_.x[i].cast<double>() + momentum * p_[i];
}

void ConjugateGradients::advance() {
  const Sums sums = ordered_sum<Sums>(finest_.corner_count(), [&](int32_t begin, int32_t end) {
    Sums sum;
    for (int32_t i = begin; i < end; ++i) {
      if (finest_.inverse_diagonal[i] == 0)
        q_[i].setZero();
      else
        q_[i] = system_row(finest_, p_, i);
      sum.first += p_[i] * q_[i];
      sum.second += p_[i] * r_[i];
    }
    return sum;
  });
  step_ = quotient(sums.second, sums.first);
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < finest_.corner_count(); ++i) {
    u_[i] += step_ * p_[i];
    r_[i] -= step_ * q_[i];
  }
}

Measures ConjugateGradients::measure() const {
  struct Totals {
    double energy = 0, residual = 0, constraint = 0;
    Totals& operator+=(const Totals& other) {
      energy += other.energy;
      residual += other.residual;
      constraint += other.constraint;
      return *this;
    }
  };
  const Totals totals = ordered_sum<Totals>(finest_.corner_count(), [&](int32_t begin, int32_t end) {
    Totals sum;
    for (int32_t i = begin; i < end; ++i) {
      const double scale = finest_.inverse_diagonal[i];
      if (scale == 0) continue;
      sum.energy -= 0.5 * (u_[i] * (b_[i] + r_[i])).sum();
      sum.residual += scale * r_[i].square().sum();
      sum.constraint += scale * b_[i].square().sum();
    }
    return sum;
  });
  Measures measures;
  measures.energy = totals.energy;
  measures.residual =
      totals.constraint > 0 ? std::sqrt(totals.residual / totals.constraint) : 0.0;
  measures.correction_max = correction_max_;
  return measures;
}

uint64_t ConjugateGradients::byte_count() const {
  return bytes_of(u_) + bytes_of(b_) + bytes_of(r_) + bytes_of(p_) + bytes_of(q_);
}

}  // namespace burnish::cpu

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// What is known of an eigenvalue beforehand.
struct Bounds {
  double least;
  double most;
};

/// Estimates the largest eigenvalue of M⁻¹S by power iteration, from one matrix to the next: each
/// starts from the last one's eigenvector, because between two edits little changes.
class LambdaMax {
 public:
  explicit LambdaMax(size_t corner_count) : eigenvector_(corner_count) {}

  /// With a margin, so that it is not below; the last one while depth.is_spectrum_new is false.
  /// `apply` sets depth.x = −M⁻¹ depth.r. Changes x, f, r.
  float estimate(CpuDepth& depth, Bounds bounds, const std::function<void()>& apply);
  uint64_t byte_count() const { return bytes_of(eigenvector_); }

 private:
  void set_start(const std::vector<float>& inverse_diagonal);

  std::vector<Float4> eigenvector_;
  bool started_ = false;
  float latest_ = 0;
};

}  // namespace burnish::cpu

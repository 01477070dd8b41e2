#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Bounds of an eigenvalue that hold for any matrix.
struct Bounds {
  double least;
  double most;
};

/// Estimates the largest eigenvalue of M⁻¹S by power iteration. Each estimate starts from the last
/// matrix's eigenvector, because little changes between two edits.
class LambdaMax {
 public:
  explicit LambdaMax(size_t corner_count) : eigenvector_(corner_count) {}

  /// Returns the estimate with a margin, so that it is not too small; the last one while
  /// depth.is_spectrum_new is false. `apply` sets depth.x = −M⁻¹ depth.r. Changes x, f, r.
  float estimate(CpuDepth& depth, Bounds bounds, const std::function<void()>& apply);
  /// The next estimate is a first one.
  void start_over() { started_ = false; }
  uint64_t byte_count() const { return bytes_of(eigenvector_); }

 private:
  void set_start(const std::vector<float>& inverse_diagonal);

  std::vector<Float4> eigenvector_;
  bool started_ = false;
  float latest_ = 0;
};

}  // namespace burnish::cpu

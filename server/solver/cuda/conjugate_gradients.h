#pragma once

#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// Flexible conjugate gradients in double, as on the CPU: see cpu/conjugate_gradients.h. Steps and
/// sums stay on the device; only measure() waits for them.
class ConjugateGradients {
 public:
  /// What one step hands to the next, per column.
  struct Scalars {
    double z_dot_r[3];
    double step[3];  ///< a of the last advance()
    double momentum[3];
    float correction_squared_max;
    double energy, residual, constraint;
  };
  /// What the kernels work on.
  struct Vectors {
    Depth finest;
    ExactMatrix matrix;
    Double3 *u, *b, *r, *p, *q;
    double* partials;
    Scalars* scalars;
  };

  ConjugateGradients(Stream& stream, const Depth& finest, const VertexPlace* evaluation,
                     size_t vertex_count);

  const ExactMatrix& matrix() const { return vectors_.matrix; }
  Double3* constraint() const { return vectors_.b; }
  Double3* residual() const { return vectors_.r; }
  const DeviceArray<Double3>& displacement() const { return u_; }

  void recompute_residual();
  void load_residual();
  void update_direction(bool restart);
  void advance();
  /// The sums of backend.h's Measures after the last advance(), not yet divided and rooted. Waits
  /// for the device.
  Scalars measure() const;
  uint64_t byte_count() const;

 private:
  Stream& stream_;
  int64_t n_;
  const VertexPlace* evaluation_;
  int64_t vertex_count_;
  DeviceArray<double> entry_, row_sum_, partials_;
  DeviceArray<Double3> u_, b_, r_, p_, q_;
  DeviceArray<Scalars> scalars_;
  Vectors vectors_;
};

}  // namespace burnish::cuda

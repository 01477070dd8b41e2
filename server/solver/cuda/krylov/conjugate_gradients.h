#pragma once

#include "server/solver/cuda/device/branch.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

class Halo;

/// Flexible conjugate gradients in double, as on the CPU: see cpu/krylov/conjugate_gradients.h.
/// Steps and sums stay on the device; only measure() waits for them.
///
/// A step has two passes over the depth. z is the V-cycle's correction. The first pass makes w = S
/// z and its sums; p, q = S p and p·q follow from these and the last p's. The second makes p, q, u
/// and r with their sums, and E p of the vertices, which gives their moves. E z is made next to the
/// first.
///
/// Each kernel that writes r also writes it in float32, as the next cycle's f.
class ConjugateGradients {
 public:
  /// The values of one step that the next one needs, per column.
  struct Scalars {
    double z_dot_r[3];
    double p_dot_q[3], p_dot_r[3];  ///< after the last advance()
    double step[3];                 ///< a of the last advance()
    double momentum[3];
    double scale[3];          ///< a of the last rescale()
    float moved_squared_max;  ///< of |E a p| at a vertex
    double energy, residual, constraint;
  };
  /// The data of the kernels.
  struct Vectors {
    Depth finest;
    double* row_sum;  ///< of S
    Double3 *u, *r, *p, *q, *w;
    Constraint b;
    int64_t vertex_count;
    float4 *vertex_z, *vertex_p;  ///< E z and E p, one per vertex
    Partials<9> products;
    Partials<9> measures;
    Scalars* scalars;
    Scalars* measured;  ///< a copy on the host, after advance()
    double* totals;     ///< for the other shards; null if the depth is whole
  };

  /// `halo`: to the other shards, which have the depth as `number`; null if it is whole.
  ConjugateGradients(Stream& stream, const Depth& finest, const VertexPlace* evaluation,
                     size_t vertex_count, Halo* halo, int number);

  double* row_sum() const { return vectors_.row_sum; }
  const Constraint& constraint() const { return vectors_.b; }
  Double3* residual() const { return vectors_.r; }
  const DeviceArray<Double3>& displacement() const { return u_; }

  void start_over();  ///< u = 0, and nothing of the last step
  void recompute_residual();
  void rescale();
  void refresh_residual();  ///< brings f of other shards; call after a change of r from outside
  void update_direction(bool restart);
  void advance();
  /// Returns the sums of backend.h's Measures after the last advance(), before division and root.
  /// Waits for the device.
  Scalars measure() const;
  uint64_t byte_count() const;

 private:
  OfShards totals_of_all();

  Stream& stream_;
  int64_t n_;
  const VertexPlace* evaluation_;
  Branch branch_{stream_};
  DeviceArray<double> row_sum_, slider_less_one_;
  DeviceArray<Double3> u_, b_per_slider_, b_own_, r_, p_, q_, w_;
  DeviceArray<uint8_t> is_painted_, is_touched_;
  DeviceArray<float4> vertex_z_, vertex_p_;
  DeviceArray<Sums<9>> product_sums_, measure_sums_;
  DeviceArray<unsigned> arrived_;
  DeviceArray<Scalars> scalars_;
  PinnedArray<Scalars> measured_;
  DeviceArray<double> totals_;
  Vectors vectors_;
  Halo* halo_;
  int number_;  // of the depth
};

}  // namespace burnish::cuda

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/fields/fields_view.h"
#include "server/solver/cycle/convergence_rate.h"
#include "server/solver/cycle/multigrid.h"
#include "server/solver/cycle/smoother_names.h"

namespace burnish {

enum class BackendKind { kAuto, kCpu, kCuda };

/// The facts of one step.
struct StepReport {
  int cycle = 0;        ///< since the solver was made or started over
  double energy = 0;    ///< ½uᵀSu − bᵀu summed over x, y, z; never rises between edits
  double residual = 0;  ///< ‖r‖ over ‖b‖ in the diagonally scaled norm
  double distance = 0;  ///< estimate of the largest distance of a vertex to the converged surface,
                        ///< over the bounding-box diagonal
  bool fell_back = false;  ///< a step since the last metric was not sound: a plainer smoother,
                           ///< with more cycles to the same end, has done the others
};

struct SolveReport {
  int cycles = 0;
  bool converged = false;
  StepReport last;
  double assemble_seconds = 0;  ///< matrices and constraint
  double solve_seconds = 0;
};

struct SolverOptions {
  BackendKind backend = BackendKind::kAuto;
  Smoother smoother = Smoother::kSchwarz;
  int threads = 0;  ///< 0: all cores
  /// Number of devices that share the scan. 0: one, or as many as have room for it. On processors,
  /// the number of shards.
  int devices = 0;
  int32_t whole_corners_max = 400'000;  ///< see kWholeCornersMax
};

/// Returns on how many devices Solver::create() tries to put a scan; 0: it takes the processors.
int devices_for(const Multigrid& on, const SolverOptions& options);

class Backend;
struct Measures;

/// The screened Poisson system of one session: S u = b for the displacement u of every corner. Each
/// step starts from the last one's result. Source: sections 4 and 5.2.
class Solver {
 public:
  /// Asked for the host's memory before kAuto turns from devices to the processors.
  using RoomOnProcessors = std::function<Status()>;

  /// kAuto takes CUDA if it works, else the CPU. Fails: failed_precondition if the backend is not
  /// in this build or finds no device; unimplemented, resource_exhausted: see cuda_backend.h; as
  /// `room` says.
  static Result<std::unique_ptr<Solver>> create(Multigrid on, const SolverOptions& options,
                                                const RoomOnProcessors& room = {});
  ~Solver();

  /// Solves for the displacement of a signal on the surface, such as its colours, instead of that
  /// of the surface. Call it before the first metric. Results are in the signal's units; distances
  /// take these for cells. Shapes: one per corner of the finest depth.
  void set_signal(std::span<const Vec3f> signal);

  /// Makes new matrices at all depths and a new constraint: α1, α2 and perhaps β changed.
  void set_metric(const FieldsView& fields);
  /// Does the same from u = 0, as a new solver does: then results depend on the fields alone, not
  /// on what came before.
  void start_over(const FieldsView& fields);
  /// Makes only a new constraint: β changed.
  void set_gradient_scale(const FieldsView& fields);

  /// Does one iteration of conjugate gradients, preconditioned by one V-cycle. If its result is not
  /// sound, starts again from u = 0 with Backend::fall_back(). If that fails too, u is 0, the
  /// distance is that of the whole box, and soundness() says so until the next change of the
  /// system. Needs: set_metric().
  StepReport step();

  /// Steps until the estimated distance is at most `distance_max` (of the bounding-box diagonal) or
  /// `cycles_max` steps are done. Fails: cancelled, with the displacement of the last step; as
  /// status() and soundness() say.
  Result<SolveReport> solve(double distance_max, int cycles_max, const Progress& progress = {});

  /// Returns u, one per corner of the finest depth. Valid until the next call. Units: cells.
  std::span<const Vec3f> displacement() const;
  /// Returns E u, one per vertex, likewise.
  std::span<const Vec3f> vertex_displacement() const;
  /// Returns the displaced positions E(c° + u) in file units, one per vertex.
  std::vector<Vec3d> evaluate_vertices() const;

  uint64_t byte_count() const;            ///< of this session, without the multigrid
  std::string_view backend_name() const;  ///< "cpu", "cuda"
  /// Says why it is that backend: "NVIDIA H200, 143156 MiB", "requested", "no CUDA device: ...".
  const std::string& backend_reason() const { return backend_reason_; }
  /// Returns the first failure of the backend's machine. After it results here have no meaning.
  Status status() const;
  /// Fails: internal_error if the present system has no sound step.
  const Status& soundness() const { return soundness_; }

 private:
  Solver(Multigrid on, std::unique_ptr<Backend> backend, std::string backend_reason, int threads);

  /// Says how the next step starts, by rising distance. From kNewConstraint on, the direction is
  /// new.
  enum Start { kGoesOn, kNewConstraint, kNewMetric, kCold };
  void start_from(const FieldsView& fields, Start start);
  Measures iterate();
  Measures recover();
  StepReport no_step();

  Multigrid on_;
  std::unique_ptr<Backend> backend_;
  std::string backend_reason_;
  int threads_;
  ConvergenceRate rate_;
  int cycle_ = 0;
  double energy_ = 0;  // after the last step; 0 if nothing is displaced
  Start start_ = kCold;
  bool residual_is_stale_ = true;
  double gradient_scale_ = kBetaDefault;  // of the constraint
  bool rescale_ = false;                  // before the next step
  bool has_fallen_back_ = false;          // since the last metric
  Status soundness_;                      // no step was
  double assemble_seconds_ = 0;
};

}  // namespace burnish

#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

enum class BackendKind { kAuto, kCpu, kCuda };
enum class Smoother {
  kGaussSeidel,  ///< 8-colour point Gauss-Seidel, the paper's
  kSchwarz,      ///< Chebyshev on additive Schwarz over cells, the default
};

/// What one step found and did.
struct StepReport {
  int cycle = 0;             ///< since the solver was made
  double energy = 0;         ///< ½uᵀSu − bᵀu summed over x, y, z: never rises between edits
  double residual = 0;       ///< ‖r‖ in the diagonally scaled norm over that of b
  double distance = 0;       ///< estimated largest vertex distance to the converged surface, over
                             ///< the bounding-box diagonal
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
};

/// The screened Poisson system of one session: S u = b for the displacement u of every corner,
/// warm-started from step to step. Source: sections 4 and 5.2.
class Solver {
 public:
  /// Fails: failed_precondition when the backend is not in this build or has no device.
  static Result<std::unique_ptr<Solver>> create(std::shared_ptr<const PreparedMesh> prepared,
                                                const SolverOptions& options);
  virtual ~Solver();

  /// New matrices at all depths and a new constraint. Shapes: one per cell. Units: user α.
  void set_metric(std::span<const float> alpha1, std::span<const float> alpha2);
  /// A new constraint only. Shapes: one per cell.
  void set_gradient_scale(std::span<const float> beta);

  /// One iteration of conjugate gradients preconditioned by one V-cycle.
  StepReport step();

  /// Steps until the estimated distance is below `distance_max` or `cycles_max` is met.
  /// Fails: cancelled.
  Result<SolveReport> solve(double distance_max, int cycles_max, const Progress& progress = {});

  /// Displaced vertex positions E(c° + u) in file units, one per vertex.
  void evaluate_vertices(std::span<Vec3d> vertices) const;

  /// Session memory, and the shared part per mesh, in bytes.
  uint64_t byte_count() const;
  std::string_view backend_name() const;  ///< "cpu", "cuda"
};

}  // namespace burnish

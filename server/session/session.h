#pragma once

#include <memory>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/edit/edit.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/prepared_mesh.h"
#include "server/session/edited_fields.h"
#include "server/session/previews.h"
#include "server/solver/solver.h"

namespace burnish {

/// The estimated distance at which a session is called settled: well below the bar of 1e-4
/// (docs/solver.md, "How exact"), for the estimate is not a bound.
inline constexpr double kSettledDistance = 3e-5;

/// When a solve ends: after a fixed number of cycles, or when the estimated distance to the
/// converged surface is below a bar.
struct SolveOptions {
  bool exact = false;  ///< to the bar of exports, else of settled sessions (docs/solver.md)
  int cycles = 0;      ///< > 0: exactly this many
};

/// One editing state of a prepared mesh: edits in, fields, solver, surface out.
/// Not thread-safe: its owner serialises calls.
class Session {
 public:
  /// Fails: failed_precondition (no such backend here); resource_exhausted (no memory).
  static Result<std::unique_ptr<Session>> open(const Multigrid& on, const SolverOptions& options);
  ~Session();

  /// Edits in, all of a batch or none; the solver sees them at the next step, as new matrices or
  /// as a new constraint only, once for all.
  EditedFields& edited();
  const EditedFields& edited() const;

  /// One edit of nobody in particular.
  Status apply(const Edit& edit);

  /// What is shown beside the edits until it becomes one.
  Previews& previews();

  /// Whether there are edits or previews that the solver has not seen.
  bool is_changed() const;

  /// Brings the system up to date with the edits and the previews.
  void update();

  /// The same if need be, and relaxes by one cycle.
  StepReport step();

  /// Whether a surface is at the bar of settled sessions, or as near as this solver comes to it:
  /// then nothing is left to do until something changes.
  bool is_settled(const StepReport& last) const;

  /// Whether it is at the bar of exports even.
  bool is_exact(const StepReport& last) const;

  /// Relaxes, without the previews, until the end that `options` asks for. Fails: cancelled.
  Result<SolveReport> solve(const SolveOptions& options, const Progress& progress = {});

  /// The surface as it is now: same triangles, same colours, moved vertices.
  TriangleMesh surface() const;

  const PreparedMesh& prepared() const;
  const Fields& fields() const { return edited().fields(); }
  const Solver& solver() const;
  uint64_t byte_count() const;  ///< of this session alone

 private:
  struct State;
  explicit Session(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish

#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/edit/edit.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/fields.h"
#include "server/solver/solver.h"

namespace burnish {

/// How an export ends: by a fixed number of cycles, or when the estimated distance to the
/// converged surface is below a bar.
struct ExportOptions {
  bool exact = false;  ///< to the export bar; else to the settled bar
  int cycles = 0;      ///< > 0: exactly this many cycles from where the session is
};

struct SessionOptions {
  BackendKind backend = BackendKind::kAuto;
  Smoother smoother = Smoother::kSchwarz;
  int threads = 0;
};

/// One user's editing state of a prepared mesh: edits in, fields, solver, surface out.
/// Not thread-safe: its owner serialises calls.
class Session {
 public:
  /// Fails: resource_exhausted, failed_precondition (no such backend here).
  static Result<std::unique_ptr<Session>> open(std::shared_ptr<const PreparedMesh> prepared,
                                               const SessionOptions& options);
  ~Session();

  /// Validates and applies; the solver sees it at the next step.
  Status apply(const Edit& edit);

  /// Brings the system up to date with the edits and relaxes by one cycle.
  StepReport step();

  /// Solves as asked and returns the edited mesh: same triangles, same colours, moved vertices.
  /// Fails: cancelled.
  Result<TriangleMesh> export_mesh(const ExportOptions& options, const Progress& progress,
                                   SolveReport* report = nullptr);

  /// The surface as it is now, without solving.
  std::vector<Vec3d> vertices() const;

  const PreparedMesh& prepared() const;
  const Fields& fields() const;
  const Solver& solver() const;
  uint64_t byte_count() const;

 private:
  struct State;
  explicit Session(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish

#include "server/session/session.h"

#include "server/metrics/live_objects.h"
#include "server/solver/hierarchy.h"

namespace burnish {

// Well below the bars of ARCHITECTURE section 5 (1e-4 and 1e-5), for the estimate is not a bound.
static constexpr double kSettledDistance = 1e-5;
static constexpr double kExactDistance = 1e-7;
static constexpr int kCyclesMax = 500;

struct Session::State {
  State(std::shared_ptr<const PreparedMesh> prepared_mesh, std::unique_ptr<Solver> session_solver)
      : prepared(std::move(prepared_mesh)), fields(*prepared), solver(std::move(session_solver)) {}

  void update_solver() {
    if (metric_changed)
      solver->set_metric(fields.view());
    else if (beta_changed)
      solver->set_gradient_scale(fields.view());
    metric_changed = beta_changed = false;
  }

  Status apply(const SetGradientScale& change) {
    fields.set_gradient_scale(change.beta);
    beta_changed = true;
    return Status::ok();
  }
  Status apply(const SetTransferCurve& change) {
    fields.set_transfer_curve(change.curve);
    metric_changed = true;
    return Status::ok();
  }
  Status apply(const Stroke& stroke) {
    fields.paint(stroke);
    beta_changed = true;
    return Status::ok();
  }
  Status apply(const SetCellFields& change) {
    RETURN_IF_ERROR(fields.override_cells(change));
    metric_changed = true;
    return Status::ok();
  }

  std::shared_ptr<const PreparedMesh> prepared;
  Fields fields;
  std::unique_ptr<Solver> solver;
  LiveObject live{LiveKind::kSession};
  bool metric_changed = true;
  bool beta_changed = true;
};

Result<std::unique_ptr<Session>> Session::open(std::shared_ptr<const PreparedMesh> prepared,
                                               std::shared_ptr<const Hierarchy> hierarchy,
                                               const SolverOptions& options) {
  ASSIGN_OR_RETURN(auto solver, Solver::create(prepared, std::move(hierarchy), options));
  return std::unique_ptr<Session>(
      new Session(std::make_unique<State>(std::move(prepared), std::move(solver))));
}

Session::Session(std::unique_ptr<State> state) : state_(std::move(state)) {}
Session::~Session() = default;

Status Session::apply(const Edit& edit) {
  RETURN_IF_ERROR(validate(edit));
  return std::visit([&](const auto& change) { return state_->apply(change); }, edit.change);
}

StepReport Session::step() {
  state_->update_solver();
  return state_->solver->step();
}

Result<SolveReport> Session::solve(const SolveOptions& options, const Progress& progress) {
  state_->update_solver();
  if (options.cycles > 0) return state_->solver->solve(0, options.cycles, progress);
  return state_->solver->solve(options.exact ? kExactDistance : kSettledDistance, kCyclesMax,
                               progress);
}

TriangleMesh Session::surface() const {
  const PreparedMesh& prepared = *state_->prepared;
  TriangleMesh mesh;
  mesh.vertices = state_->solver->evaluate_vertices();
  mesh.triangles.assign(prepared.triangles.begin(), prepared.triangles.end());
  mesh.colours.assign(prepared.colours.begin(), prepared.colours.end());
  mesh.has_double_positions = prepared.has_double_positions;
  return mesh;
}

const PreparedMesh& Session::prepared() const {
  return *state_->prepared;
}
const Fields& Session::fields() const {
  return state_->fields;
}
const Solver& Session::solver() const {
  return *state_->solver;
}

}  // namespace burnish

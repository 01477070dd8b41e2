#include "server/session/session.h"

#include "common/base/out_of_memory.h"
#include "common/evaluation/evaluation.h"
#include "server/metrics/live_objects.h"
#include "server/session/shown_displacement.h"

namespace burnish {

static constexpr double kExactDistance = 3e-7;  // below the bar of exports, 1e-5, likewise
static constexpr int kCyclesMax = 500;

struct Session::State {
  State(const Multigrid& on, std::unique_ptr<Solver> session_solver, const Controls& born_with)
      : prepared(on.prepared),
        hierarchy(on.hierarchy),
        edited(*prepared, born_with),
        solver(std::move(session_solver)),
        shown(*prepared, hierarchy->at(hierarchy->finest).grid) {}

  void update_solver(const Fields& fields, const EditedFields::Changes& changes) {
    if (changes.metric)
      solver->set_metric(fields.view());
    else if (changes.beta)
      solver->set_gradient_scale(fields.view());
    if (changes.any()) cycles_since_change = 0;
  }

  const Fields& shown_fields() const { return previews.shown(edited.fields()); }

  std::shared_ptr<const PreparedMesh> prepared;
  std::shared_ptr<const Hierarchy> hierarchy;
  EditedFields edited;
  Previews previews;
  int cycles_since_change = 0;
  bool is_settled = false;  // after the last step
  std::unique_ptr<Solver> solver;
  ShownDisplacement shown;
  LiveObject live{LiveKind::kSession};
};

Result<std::unique_ptr<Session>> Session::open(const Multigrid& on, const SolverOptions& options,
                                               const Controls& born_with) {
  using Opened = Result<std::unique_ptr<Session>>;
  return with_memory_for("opening a session", [&]() -> Opened {
    ASSIGN_OR_RETURN(auto solver, Solver::create(on, options));
    return std::unique_ptr<Session>(
        new Session(std::make_unique<State>(on, std::move(solver), born_with)));
  });
}

Session::Session(std::unique_ptr<State> state) : state_(std::move(state)) {}
Session::~Session() = default;

EditedFields& Session::edited() {
  return state_->edited;
}
const EditedFields& Session::edited() const {
  return state_->edited;
}

Status Session::apply(const Edit& edit) {
  const AuthoredEdit authored{"", 0, edit};
  return state_->edited.apply({&authored, 1}).status();
}

Previews& Session::previews() {
  return state_->previews;
}

const Fields& Session::shown_fields() const {
  return state_->shown_fields();
}

bool Session::is_changed() const {
  const EditedFields& edited = state_->edited;
  return edited.is_behind() || edited.changes().any() || state_->previews.is_changed();
}

void Session::update() {
  (void)state_->edited.catch_up();  // nobody cancels it
  EditedFields::Changes changes = state_->edited.take_changes();
  const Fields& shown = state_->previews.over(state_->edited.fields(), changes);
  state_->update_solver(shown, changes);
}

StepReport Session::step() {
  if (is_changed()) update();
  ++state_->cycles_since_change;
  const StepReport report = state_->solver->step();
  state_->is_settled = is_settled(report);
  return report;
}

bool Session::is_settled(const StepReport& last) const {
  if (is_changed() || state_->cycles_since_change == 0) return false;
  return last.distance <= kSettledDistance || state_->cycles_since_change >= kCyclesMax;
}

bool Session::is_exact(const StepReport& last) const {
  return is_settled(last) && last.distance <= kExactDistance;
}

Result<SolveReport> Session::solve(const SolveOptions& options, const Progress& progress) {
  RETURN_IF_ERROR(state_->edited.catch_up(progress));
  EditedFields::Changes changes = state_->edited.take_changes();
  changes |= state_->previews.set_aside();
  state_->update_solver(state_->edited.fields(), changes);
  const bool is_counted = options.cycles > 0;
  const double distance_max = options.exact ? kExactDistance : kSettledDistance;
  // No distance is below -1, so it does exactly the requested cycles.
  auto solved = state_->solver->solve(is_counted ? -1 : distance_max,
                                      is_counted ? options.cycles : kCyclesMax, progress);
  if (solved.is_ok()) state_->cycles_since_change += solved.value().cycles;
  return solved;
}

std::span<const Vec3f> Session::displacement() {
  return state_->shown.of(state_->solver->displacement(), state_->edited.controls(),
                          state_->shown_fields(), state_->is_settled);
}

std::vector<Vec3d> Session::moved_vertices() {
  const PreparedMesh& prepared = *state_->prepared;
  const Controls& controls = state_->edited.controls();
  const Fields& fields = state_->edited.fields();
  if (!ShownDisplacement::is_needed(controls, fields)) return state_->solver->evaluate_vertices();
  const SparseGrid& grid = state_->hierarchy->at(state_->hierarchy->finest).grid;
  const auto shown = state_->shown.of(state_->solver->displacement(), controls, fields, true);
  std::vector<Vec3d> positions(prepared.vertices.begin(), prepared.vertices.end());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < positions.size(); ++v)
    positions[v] +=
        prepared.frame.cell_size * evaluate(grid, prepared.evaluation[v], shown).cast<double>();
  return positions;
}

TriangleMesh Session::surface() {
  const PreparedMesh& prepared = *state_->prepared;
  TriangleMesh mesh;
  mesh.vertices = moved_vertices();
  mesh.triangles.assign(prepared.triangles.begin(), prepared.triangles.end());
  mesh.colours.assign(prepared.colours.begin(), prepared.colours.end());
  mesh.has_double_positions = prepared.has_double_positions;
  return mesh;
}

const PreparedMesh& Session::prepared() const {
  return *state_->prepared;
}
const Solver& Session::solver() const {
  return *state_->solver;
}
uint64_t Session::byte_count() const {
  return state_->solver->byte_count() + state_->edited.byte_count() +
         state_->previews.byte_count() + state_->shown.byte_count();
}

}  // namespace burnish

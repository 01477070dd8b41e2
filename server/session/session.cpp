#include "server/session/session.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "common/base/out_of_memory.h"
#include "common/evaluation/evaluation.h"
#include "server/metrics/live_objects.h"
#include "server/session/band_mix.h"
#include "server/session/band_surfaces.h"
#include "server/session/colour_channel.h"
#include "server/session/kept_edges.h"
#include "server/session/shown_displacement.h"

namespace burnish {

static constexpr double kExactDistance = 3e-7;  // below the bar of exports, 1e-5, likewise
static constexpr int kCyclesMax = 500;

struct Session::State {
  State(const Multigrid& on, const SolverOptions& options, std::unique_ptr<Solver> session_solver,
        const Controls& initial)
      : prepared(on.prepared),
        hierarchy(on.hierarchy),
        edited(*prepared, initial),
        solver(std::move(session_solver)),
        bands(on, options),
        colour(on, options),
        edges(prepared, hierarchy->at(hierarchy->finest).grid, options.backend, options.threads),
        mix(hierarchy->at(hierarchy->finest).grid),
        shown(*prepared, hierarchy->at(hierarchy->finest).grid) {}

  const SparseGrid& grid() const { return hierarchy->at(hierarchy->finest).grid; }

  // Needs: edges.want() or edges.show() with these fields.
  FieldsView view_of(const Fields& fields) const {
    FieldsView view = fields.view();
    view.target = edges.target();
    return view;
  }

  /// Adds to the changes that the kept edges have another target.
  void note_target(EditEffects& changes) {
    const TargetView target = edges.target();
    changes.beta |= !target.is_same(std::exchange(seen_target, target));
  }

  void update_solver(const Fields& fields, const EditEffects& changes) {
    if (changes.metric)
      solver->set_metric(view_of(fields));
    else if (changes.beta)
      solver->set_gradient_scale(view_of(fields));
    if (changes.metric || changes.beta) {
      cycles_since_change = 0;
      solved = {};
    }
    show_to_others(fields);
    surface_revision += changes.any();
    is_from_scan &= !changes.metric && !changes.beta && !bands.is_solving() && !colour.is_solving();
  }

  void update_for(const SolveOptions& options, const EditEffects& changes) {
    const bool is_new = changes.metric || changes.beta;
    if (!options.exact || !is_new) update_solver(edited.fields(), changes);
    if (options.exact && (is_new || !is_from_scan)) start_over(edited.fields());
    is_from_scan = options.exact;
  }

  void start_over(const Fields& fields) {
    solver->start_over(view_of(fields));
    cycles_since_change = 0;
    solved = {};
    show_to_others(fields);
    bands.start_over();
    colour.start_over();
    ++surface_revision;
  }

  void show_to_others(const Fields& fields) {
    bands.want(fields);
    colour.want(fields);
  }

  bool solver_is_settled(const StepReport& report) const {
    if (cycles_since_change == 0) return false;
    return report.distance <= kSettledDistance || cycles_since_change >= kCyclesMax ||
           !solver->soundness().is_ok();
  }

  void step_bands() {
    const Result<bool> found = bands.step();
    if (!found.is_ok()) status = found.status();
    if (!found.is_ok() || *found) ++surface_revision;
  }

  void step_colour() {
    if (const Status stepped = colour.step(); !stepped.is_ok()) status = stepped;
    ++surface_revision;
  }

  StepReport step_solver() {
    ++cycles_since_change;
    solved = {};
    return last = solver->step();
  }

  // A gain's frame does not read the solver's displacement again.
  std::span<const Vec3f> mixed(const Fields& fields) {
    if (solved.empty()) solved = solver->displacement();
    return mix.of(solved, fields, bands);
  }

  const Fields& shown_fields() const { return previews.shown(edited.fields()); }

  /// Returns the controls of what corners do: beside kept edges the cap bounds the sum with the
  /// layer.
  Controls corner_controls() const {
    Controls controls = edited.controls();
    if (edges.is_on()) controls.cap = 0;
    return controls;
  }

  std::vector<Vec3d> vertices_at(std::span<const Vec3f> displacement) const {
    std::vector<Vec3d> places(prepared->vertices.begin(), prepared->vertices.end());
#pragma omp parallel for schedule(static)
    for (size_t v = 0; v < places.size(); ++v)
      places[v] += prepared->frame.cell_size *
                   evaluate(grid(), prepared->evaluation[v], displacement).cast<double>();
    return places;
  }

  /// Makes the layer of frames, in cells. At rest it leaves out what exports leave out.
  void make_shown_layer(std::span<const Vec3f> displacement, bool at_rest) {
    const ShownLayer wanted{at_rest, at_rest ? surface_revision : 0,
                            at_rest ? cycles_since_change : 0};
    const TargetView target = edges.target();
    if (layer.size() == prepared->vertices.size() && wanted == shown_layer &&
        target.is_same(layer_target))
      return;
    layer = edges.layer(at_rest ? vertices_at(displacement) : std::vector<Vec3d>(),
                        1 / prepared->frame.cell_size);
    shown_layer = wanted;
    layer_target = target;
  }

  /// The state that the layer of frames was made of.
  struct ShownLayer {
    bool at_rest = false;
    uint64_t surface_revision = 0;
    int cycles = 0;
    bool operator==(const ShownLayer&) const = default;
  };

  std::shared_ptr<const PreparedMesh> prepared;
  std::shared_ptr<const Hierarchy> hierarchy;
  EditedFields edited;
  Previews previews;
  int cycles_since_change = 0;
  StepReport last;
  bool is_from_scan = false;  // an exact solve led here from the scan, and nothing else
  uint64_t surface_revision = 0;
  Status status;  // of the bands and colours
  std::unique_ptr<Solver> solver;
  std::span<const Vec3f> solved;  // its displacement; empty: to be read
  BandSurfaces bands;
  ColourChannel colour;
  KeptEdges edges;
  TargetView seen_target;  // by the solver; its cells may be gone
  ShownLayer shown_layer;
  TargetView layer_target;   // likewise
  std::vector<Vec3f> layer;  // of frames, cells
  BandMix mix;
  ShownDisplacement shown;
  LiveObject live{LiveKind::kSession};
};

Result<std::unique_ptr<Session>> Session::open(const Multigrid& on, const SolverOptions& options,
                                               const Controls& initial,
                                               const Solver::RoomOnProcessors& room) {
  using Opened = Result<std::unique_ptr<Session>>;
  return with_memory_for("opening a session", [&]() -> Opened {
    ASSIGN_OR_RETURN(auto solver, Solver::create(on, options, room));
    return std::unique_ptr<Session>(
        new Session(std::make_unique<State>(on, options, std::move(solver), initial)));
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
  return edited.is_behind() || edited.changes().any() || state_->previews.is_changed() ||
         state_->edges.has_made();
}

void Session::update() {
  (void)state_->edited.catch_up();  // nobody cancels it
  EditEffects changes = state_->edited.take_changes();
  const Fields& shown = state_->previews.over(state_->edited.fields(), changes);
  const Status kept = state_->edges.show(shown, state_->edited.fields());
  if (!kept.is_ok()) state_->status = kept;
  state_->note_target(changes);
  state_->update_solver(shown, changes);
}

StepReport Session::step() {
  if (is_changed()) update();
  State& state = *state_;
  state.is_from_scan = false;
  if (state.bands.is_solving() && state.solver_is_settled(state.last)) {
    state.step_bands();
    return state.last;
  }
  if (state.colour.is_solving() && state.solver_is_settled(state.last)) {
    state.step_colour();
    return state.last;
  }
  if (state.edges.is_making() && state.solver_is_settled(state.last)) {
    static constexpr auto kOfATurn = std::chrono::milliseconds(5);
    (void)state.edges.is_made_within(kOfATurn);
    return state.last;
  }
  return state.step_solver();
}

bool Session::is_settled(const StepReport& last) const {
  return !is_changed() && !state_->bands.is_solving() && !state_->colour.is_solving() &&
         !state_->edges.is_making() && state_->solver_is_settled(last);
}

uint64_t Session::surface_revision() const {
  return state_->surface_revision;
}

Status Session::status() const {
  return state_->status.is_ok() ? state_->solver->status() : state_->status;
}

bool Session::is_exact(const StepReport& last) const {
  return is_settled(last) && last.distance <= kExactDistance;
}

Result<SolveReport> Session::solve(const SolveOptions& options, const Progress& progress) {
  RETURN_IF_ERROR(state_->edited.catch_up(progress));
  RETURN_IF_ERROR(state_->edges.want(state_->edited.fields(), progress));
  EditEffects changes = state_->edited.take_changes();
  changes |= state_->previews.set_aside();
  state_->note_target(changes);
  state_->update_for(options, changes);
  if (options.exact && is_exact(state_->last))
    return SolveReport{.converged = true, .last = state_->last};
  const bool is_counted = options.cycles > 0;
  const double distance_max = options.exact ? kExactDistance : kSettledDistance;
  // No distance is below -1, so it does exactly the requested cycles.
  auto solved = state_->solver->solve(is_counted ? -1 : distance_max,
                                      is_counted ? options.cycles : kCyclesMax, progress);
  state_->solved = {};
  if (!solved.is_ok()) return solved;
  state_->cycles_since_change += solved.value().cycles;
  state_->last = solved.value().last;
  RETURN_IF_ERROR(solve_bands(progress));
  RETURN_IF_ERROR(solve_colour(progress));
  return solved;
}

Status Session::solve_bands(const Progress& progress) {
  while (state_->bands.is_solving()) {
    const size_t bands = state_->edited.fields().equaliser().bands.size();
    const double done = double(state_->bands.known_count()) / double(bands);
    if (!report(progress, "solving bands", done)) return cancelled("the solve was cancelled");
    RETURN_IF_ERROR(state_->bands.step().status());
  }
  return Status::ok();
}

Status Session::solve_colour(const Progress& progress) {
  while (state_->colour.is_solving()) {
    if (!report(progress, "solving colours", 0)) return cancelled("the solve was cancelled");
    RETURN_IF_ERROR(state_->colour.step());
  }
  return Status::ok();
}

ColourChange Session::colour_change() const {
  return state_->colour.change();
}

std::span<const Vec3f> Session::displacement() {
  const Fields& fields = state_->shown_fields();
  return state_->shown.of(state_->mixed(fields), state_->corner_controls(), fields,
                          is_settled(state_->last));
}

bool Session::has_layer() const {
  const KeptEdges& edges = state_->edges;
  return edges.is_on() && (edges.has_layer() || state_->edited.controls().cap > 0);
}

VertexLayer Session::layer(std::span<const Vec3f> displacement) {
  State& state = *state_;
  if (!state.edges.is_on()) return {};
  const double cap = state.edited.controls().cap / state.prepared->frame.cell_size;
  if (!state.edges.has_layer()) return {.moves = {}, .cap = cap};
  // A drag that holds still is not at rest: what turns costs more than a frame to find.
  const bool at_rest = is_settled(state.last) && state.previews.empty();
  state.make_shown_layer(displacement, at_rest);
  return {state.layer, cap};
}

std::optional<double> Session::kept_volume() const {
  return state_->shown.kept_volume();
}

// A held line leaves the vertices on it some thousandths of a cell; they stay exactly.
std::vector<Vec3d> Session::moved_vertices() {
  std::vector<Vec3d> positions = evaluated_vertices();
  const PreparedMesh& prepared = *state_->prepared;
  if (const auto& rims = state_->edited.fields().rims())
    for (const uint32_t v : rims->vertices) positions[v] = prepared.vertices[v];
  return positions;
}

// The move between rounded places is within the cap, too.
static void cap_moves(std::span<const Vec3d> from, double cap, std::span<Vec3d> positions) {
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < positions.size(); ++v) {
    const Vec3d move = positions[v] - from[v];
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * positions[v].norm();
    const double most = std::max(cap - rounding, 0.0);
    if (move.norm() > most) positions[v] = from[v] + most / move.norm() * move;
  }
}

std::vector<Vec3d> Session::evaluated_vertices() {
  const PreparedMesh& prepared = *state_->prepared;
  const Controls& controls = state_->edited.controls();
  const Fields& fields = state_->edited.fields();
  const bool is_solvers = fields.equaliser().bands.empty() && !state_->edges.is_on() &&
                          !ShownDisplacement::is_needed(controls, fields);
  if (is_solvers) return state_->solver->evaluate_vertices();
  const auto shown =
      state_->shown.of(state_->mixed(fields), state_->corner_controls(), fields, true);
  std::vector<Vec3d> positions = state_->vertices_at(shown);
  if (!state_->edges.is_on()) return positions;
  state_->edges.add_layer(positions);
  if (controls.cap > 0) cap_moves(prepared.vertices, controls.cap, positions);
  return positions;
}

TriangleMesh Session::surface() {
  const PreparedMesh& prepared = *state_->prepared;
  TriangleMesh mesh;
  mesh.vertices = moved_vertices();
  mesh.triangles.assign(prepared.triangles.begin(), prepared.triangles.end());
  mesh.colours = state_->colour.colours();
  mesh.has_double_positions = prepared.has_double_positions;
  return mesh;
}

std::vector<TexelChange> Session::texels() const {
  return state_->colour.texels();
}

SeamLevelling Session::seams() const {
  const Fields& fields = state_->edited.fields();
  const PreparedMesh& prepared = *state_->prepared;
  if (prepared.colours.empty()) return {};
  SeamLevelling seams{fields.texture().level_seams, {}};
  const auto& hold = fields.colour_hold();
  if (seams.amount == 0 || !hold) return seams;
  seams.free.resize(prepared.vertices.size());
  for (size_t v = 0; v < seams.free.size(); ++v) {
    const int32_t cell = prepared.evaluation[v].cell;
    seams.free[v] = cell == kNone ? 1 : 1 - hold->weight[cell];
  }
  return seams;
}

const PreparedMesh& Session::prepared() const {
  return *state_->prepared;
}
const Solver& Session::solver() const {
  return *state_->solver;
}
uint64_t Session::byte_count() const {
  return state_->solver->byte_count() + state_->edited.byte_count() +
         state_->previews.byte_count() + state_->shown.byte_count() + state_->bands.byte_count() +
         state_->colour.byte_count() + state_->mix.byte_count() + state_->edges.byte_count() +
         state_->layer.size() * sizeof(Vec3f);
}

}  // namespace burnish

#include "server/solver/solver.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "common/base/parallel.h"
#include "server/solver/cpu/cpu_backend.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cycle/backend.h"
#include "server/solver/cycle/vcycle.h"
#include "server/solver/multi/cpu_shards.h"
#include "server/solver/multi/device_need.h"
#include "server/solver/multi/multi_backend.h"

namespace burnish {

static constexpr int kRecomputeResidualEvery = 50;  // steps; rounding makes the recurrence drift

static double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

namespace {

using Cycle = void (*)(Backend&, const Multigrid&, int depth);

// Indexed by Solver::Start. A stroke changes b nearby, a metric everywhere.
constexpr Cycle kCycles[] = {run_vcycle, run_vcycle, run_nested_iteration, run_full_multigrid};

struct ChosenBackend {
  std::unique_ptr<Backend> backend;
  std::string reason;
};

// A scan of one depth cannot be split.
bool is_split(const Multigrid& on, const SolverOptions& options) {
  return options.devices > 1 && options.smoother == Smoother::kSchwarz &&
         on.hierarchy->finest > on.hierarchy->coarsest;
}

ChosenBackend on_cpu_shards(const Multigrid& on, const SolverOptions& options) {
  const auto shards = std::make_shared<const Shards>(
      make_shards(on, std::min(options.devices, kShardsMax), options.whole_corners_max));
  auto steps = std::make_shared<LockStep>(shards->count());
  CpuShards made = make_cpu_shards(shards, *steps);
  auto halos = std::make_shared<std::vector<std::unique_ptr<cpu::Halo>>>(std::move(made.halos));
  return {make_multi_backend(on, {shards, steps, halos, std::move(made.backends)}),
          std::to_string(shards->count()) + " shards"};
}

Result<ChosenBackend> on_cuda_shards(const Multigrid& on, const SolverOptions& options, int count) {
  ASSIGN_OR_RETURN(std::string device, cuda_device());
  const auto shards = std::make_shared<Shards>(
      make_shards(on, count, options.whole_corners_max, ShardIntegrals::kLeft));
  auto steps = std::make_shared<LockStep>(count);
  std::vector<CudaShard> parts;
  for (Shard& shard : shards->all)
    parts.push_back({std::move(shard.on), shard.cells, shard.halos, &shard.border});
  const CudaShardGroup group = {shards->border, on.plan->patches.count() > 0,
                                on.prepared->integrals,
                                [steps = steps.get()](const std::function<void()>& together) {
                                  steps->arrive_and_wait(together);
                                }};
  ASSIGN_OR_RETURN(CudaShards made, make_cuda_shards(group, parts));
  return ChosenBackend{
      make_multi_backend(on, {shards, steps, made.halos, std::move(made.backends)}),
      device + "; " + std::to_string(count) + " shards"};
}

Result<ChosenBackend> on_cuda(const Multigrid& on, const SolverOptions& options) {
  if (const int devices = devices_for(on, options); devices > 1)
    return on_cuda_shards(on, options, devices);
  ASSIGN_OR_RETURN(auto backend, make_cuda_backend(on, options.smoother));
  ASSIGN_OR_RETURN(std::string device, cuda_device());
  return ChosenBackend{std::move(backend), std::move(device)};
}

Result<ChosenBackend> choose_backend(const Multigrid& on, const SolverOptions& options,
                                     const Solver::RoomOnProcessors& room) {
  if (options.backend == BackendKind::kCpu && is_split(on, options))
    return on_cpu_shards(on, options);
  std::string reason = "requested";
  if (options.backend != BackendKind::kCpu) {
    auto chosen = on_cuda(on, options);
    if (chosen.is_ok()) return chosen;
    if (options.backend == BackendKind::kCuda) return chosen.status().with_context("backend cuda");
    reason = chosen.status().message();
    if (room) RETURN_IF_ERROR(room());
  }
  return ChosenBackend{make_cpu_backend(on, options.smoother), std::move(reason)};
}

}  // namespace

int devices_for(const Multigrid& on, const SolverOptions& options) {
  if (options.backend == BackendKind::kCpu || !cuda_device().is_ok()) return 0;
  const int wanted = std::min(options.devices, kCudaShardsMax);
  if (wanted > 0) return is_split(on, options) ? wanted : 1;
  SolverOptions several = options;
  several.devices = 2;
  if (!is_split(on, several)) return 1;
  const auto there = std::min(static_cast<int>(cuda_memory_by_device().size()), kCudaShardsMax);
  const int needed = shards_that_fit(predict_device_bytes(on), cuda_memory_max());
  return std::min(needed, there);
}

Result<std::unique_ptr<Solver>> Solver::create(Multigrid on, const SolverOptions& options,
                                               const RoomOnProcessors& room) {
  use_threads(options.threads);
  if (goes_by_colours(options.smoother))
    on = {on.prepared, make_hierarchy(*on.prepared, Sheets::kTogether),
          std::make_shared<CyclePlan>()};
  ASSIGN_OR_RETURN(ChosenBackend chosen, choose_backend(on, options, room));
  return std::unique_ptr<Solver>(new Solver(std::move(on), std::move(chosen.backend),
                                            std::move(chosen.reason), options.threads));
}

Solver::Solver(Multigrid on, std::unique_ptr<Backend> backend, std::string backend_reason,
               int threads)
    : on_(std::move(on)),
      backend_(std::move(backend)),
      backend_reason_(std::move(backend_reason)),
      threads_(threads) {}

Solver::~Solver() = default;

void Solver::set_signal(std::span<const Vec3f> signal) {
  backend_->set_signal(signal);
}

void Solver::set_metric(const FieldsView& fields) {
  use_threads(threads_);
  const auto start = std::chrono::steady_clock::now();
  const bool is_whole = backend_->set_metric(fields.metric);
  has_fallen_back_ = false;
  backend_->set_constraint(fields);
  assemble_seconds_ += seconds_since(start);
  residual_is_stale_ = true;
  rescale_ |= is_whole || fields.gradient_scale != gradient_scale_;
  start_from(fields, kNewMetric);
}

void Solver::start_over(const FieldsView& fields) {
  backend_->start_over();
  rate_.restart();
  cycle_ = 0;
  energy_ = 0;
  start_ = kCold;
  gradient_scale_ = kBetaDefault;
  set_metric(fields);
}

void Solver::set_gradient_scale(const FieldsView& fields) {
  use_threads(threads_);
  const auto start = std::chrono::steady_clock::now();
  backend_->set_constraint(fields);
  assemble_seconds_ += seconds_since(start);
  rescale_ |= fields.gradient_scale != gradient_scale_;  // not for a stroke: it is local
  start_from(fields, kNewConstraint);
}

// If β was one except for paint, the unpainted surface has not moved yet.
void Solver::start_from(const FieldsView& fields, Start start) {
  const bool is_cold = energy_ == 0 || (gradient_scale_ == 1 && fields.gradient_scale != 1);
  start_ = std::max(start_, is_cold ? kCold : start);
  gradient_scale_ = fields.gradient_scale;
  soundness_ = Status::ok();
}

Measures Solver::iterate() {
  if (residual_is_stale_ || cycle_ % kRecomputeResidualEvery == 0) backend_->recompute_residual();
  if (rescale_) backend_->rescale();
  residual_is_stale_ = rescale_ = false;
  const bool restarts = start_ != kGoesOn;
  backend_->run_recorded(start_, [&] {
    kCycles[start_](*backend_, on_, on_.hierarchy->finest);
    backend_->update_direction(restarts);
    backend_->advance();
  });
  if (restarts) rate_.restart();
  start_ = kGoesOn;
  Measures measures = backend_->measure();
  measures.is_first_direction = restarts;
  return measures;
}

// Everything that a bad step has touched is set anew, so nothing of it stays.
Measures Solver::recover() {
  backend_->fall_back();
  has_fallen_back_ = residual_is_stale_ = true;
  rescale_ = false;
  start_ = kCold;
  return iterate();
}

// A frame at u = 0 is right to say that it is as far away as the box is large.
StepReport Solver::no_step() {
  if (soundness_.is_ok()) {
    soundness_ =
        internal_error("no step of the solver is sound: the surface stays as it was scanned");
    backend_->fall_back();
    residual_is_stale_ = true;
    energy_ = 0;
  }
  return {.cycle = ++cycle_, .distance = 1, .fell_back = true};
}

StepReport Solver::step() {
  use_threads(threads_);
  if (!soundness_.is_ok()) return no_step();
  Measures measures = iterate();
  if (!measures.is_sound() && backend_->status().is_ok()) measures = recover();
  if (!measures.is_sound()) return no_step();
  energy_ = measures.energy;
  rate_.add({measures.moved_max, measures.preconditioned_residual});
  StepReport report;
  report.cycle = ++cycle_;
  report.energy = measures.energy;
  report.residual = measures.residual;
  report.fell_back = has_fallen_back_;
  report.distance =
      rate_.distance() * on_.prepared->frame.cell_size / on_.prepared->statistics.diagonal();
  return report;
}

Result<SolveReport> Solver::solve(double distance_max, int cycles_max, const Progress& progress) {
  SolveReport report;
  const auto start = std::chrono::steady_clock::now();
  while (report.cycles < cycles_max && !report.converged) {
    if (!burnish::report(progress, "solve", static_cast<double>(report.cycles) / cycles_max))
      return cancelled("cancelled after " + std::to_string(report.cycles) + " cycles");
    report.last = step();
    RETURN_IF_ERROR(backend_->status());
    RETURN_IF_ERROR(soundness_);
    ++report.cycles;
    report.converged = report.last.distance <= distance_max;
  }
  report.assemble_seconds = assemble_seconds_;
  report.solve_seconds = seconds_since(start);
  return report;
}

std::span<const Vec3f> Solver::displacement() const {
  use_threads(threads_);
  return backend_->displacement();
}

std::span<const Vec3f> Solver::vertex_displacement() const {
  use_threads(threads_);
  return backend_->vertex_displacement();
}

std::vector<Vec3d> Solver::evaluate_vertices() const {
  const std::span<const Vec3f> moved = vertex_displacement();
  std::vector<Vec3d> positions(on_.prepared->vertices.begin(), on_.prepared->vertices.end());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < positions.size(); ++v)
    positions[v] += on_.prepared->frame.cell_size * moved[v].cast<double>();
  return positions;
}

uint64_t Solver::byte_count() const {
  return backend_->byte_count();
}

Status Solver::status() const {
  return backend_->status();
}

std::string_view Solver::backend_name() const {
  return backend_->name();
}

}  // namespace burnish

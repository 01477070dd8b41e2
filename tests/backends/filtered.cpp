#include "tests/backends/filtered.h"

#include <algorithm>

#include "server/prepare/prepare.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {

Filtered::Filtered(const TriangleMesh& mesh, int depth, const SolverOptions& options) {
  const auto prepared = prepare(mesh, {.depth = depth}).value();
  session_ = Session::open(make_multigrid(prepared).value(), options).value();
}

static void must(const Status& status) {
  BURNISH_CHECK(status.is_ok(), status.message());
}

Filtered& Filtered::curve(const TransferCurve& curve) {
  must(session_->apply({std::to_string(edits_++), SetTransferCurve{curve}}));
  return *this;
}

Filtered& Filtered::beta(double beta) {
  must(session_->apply({std::to_string(edits_++), SetGradientScale{beta}}));
  return *this;
}

Filtered& Filtered::paint(const Stroke& stroke) {
  must(session_->apply({std::to_string(edits_++), stroke}));
  return *this;
}

Filtered& Filtered::palette(const Palette& palette) {
  must(session_->apply({std::to_string(edits_++), SetPalette{palette}}));
  return *this;
}

Filtered& Filtered::edges(const EdgeFilter& filter) {
  must(session_->apply({std::to_string(edits_++), SetEdges{filter}}));
  return *this;
}

Filtered& Filtered::controls(const Controls& controls) {
  must(session_->apply({std::to_string(edits_++), SetControls{controls}}));
  return *this;
}

std::vector<Vec3d> Filtered::after(int cycles) {
  for (int i = 0; i < cycles; ++i) session_->step();
  return session_->surface().vertices;
}

std::vector<Vec3d> Filtered::solved(const SolveOptions& options) {
  const SolveReport report = session_->solve(options).value();
  BURNISH_CHECK(report.converged, "not converged after " + std::to_string(report.cycles));
  return session_->surface().vertices;
}

std::vector<BackendCase> backend_cases() {
  std::vector<BackendCase> cases = every_smoother_cases();
  std::erase_if(cases, [](const BackendCase& c) {
    return c.options.smoother != Smoother::kSchwarz && c.options.smoother != Smoother::kGaussSeidel;
  });
  constexpr int kShards = 3, kFewCorners = 500;  // all depths with more are split
  const auto add_split = [&](const char* name, BackendKind backend) {
    cases.push_back(
        {name, {.backend = backend, .devices = kShards, .whole_corners_max = kFewCorners}});
  };
  add_split("cpu_in_shards", BackendKind::kCpu);
  if (cuda_device().is_ok()) add_split("cuda_in_shards", BackendKind::kCuda);
  return cases;
}

std::vector<BackendCase> every_smoother_cases() {
  std::vector<BackendCase> cases;
  const auto add = [&](BackendKind backend, const char* backend_name, Smoother smoother) {
    std::string name = backend_name + ("_" + std::string(name_of(smoother)));
    std::ranges::replace(name, '-', '_');
    cases.push_back({name, {.backend = backend, .smoother = smoother}});
  };
  for (const NamedSmoother& named : kSmoothers) add(BackendKind::kCpu, "cpu", named.smoother);
  if (cuda_device().is_ok())
    for (const Smoother smoother : kCudaSmoothers) add(BackendKind::kCuda, "cuda", smoother);
  return cases;
}

}  // namespace burnish

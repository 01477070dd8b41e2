// Measures the cost of one session, and of many, on a GPU: one table, medians.
// Usage: device_bench cpu|cuda SCAN[@DEPTH]...      SCAN: a mesh file or
// KIND:VERTICES[:STRETCH]

#include <cstdio>
#include <iostream>
#include <span>
#include <thread>

#include "server/fields/fields.h"
#include "server/solver/cuda/cuda_backend.h"
#include "tests/bench/device_trace.h"
#include "tests/bench/frames.h"
#include "tests/bench/input.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr double kCornersMax = 1e8;
constexpr int kSettles = 5;
constexpr int kTraces = 9;
constexpr int kCyclesMax = 500;
constexpr int kManySessions = 64;
constexpr int64_t kCornersOfManyMax = 1'000'000;

Result<std::unique_ptr<Session>> open_session(const BenchSystem& system, BackendKind backend) {
  return Session::open(system, {.backend = backend});
}

TransferCurve contrast_100() {
  return TransferCurve::parse("-20:5,20:500").value();
}

Stroke stroke_on(const PreparedMesh& prepared, double beta) {
  Stroke stroke;
  stroke.brush = {.radius = 0.03 * prepared.statistics.diagonal(), .beta = beta};
  stroke.path = {prepared.vertices[prepared.vertices.size() / 2]};
  return stroke;
}

/// Milliseconds and steps until the estimated distance is below a bar.
struct Settling {
  double milliseconds = 0;
  int steps = 0;
};

Settling settle(Session& session, double distance) {
  Settling settling;
  settling.milliseconds = milliseconds([&] {
    while (settling.steps < kCyclesMax) {
      ++settling.steps;
      if (session.step().distance <= distance) break;
    }
  });
  return settling;
}

/// Returns the median by time of several runs. `prepare` makes a change before each.
template <typename Prepare>
Settling median_settling(Session& session, double distance, Prepare&& prepare) {
  std::vector<Settling> runs;
  for (int i = 0; i < kSettles; ++i) {
    prepare(i);
    runs.push_back(settle(session, distance));
  }
  std::nth_element(
      runs.begin(), runs.begin() + kSettles / 2, runs.end(),
      [](const Settling& a, const Settling& b) { return a.milliseconds < b.milliseconds; });
  return runs[kSettles / 2];
}

void print_settling(const char* what, const Settling& settling) {
  std::printf("  %-44s %9.3f ms, %d steps\n", what, settling.milliseconds, settling.steps);
}

// From a settled surface a change of β from 1 to 0 is as far as a cold start.
void print_settlings(Session& session) {
  const PreparedMesh& prepared = session.prepared();
  for (const double alpha : {5.0, 50.0}) {
    must_apply(session, SetTransferCurve{TransferCurve(alpha)});
    const Settling cold = median_settling(session, 1e-4, [&](int) {
      must_apply(session, SetGradientScale{1});
      settle(session, 1e-6);
      must_apply(session, SetGradientScale{0});
    });
    print_settling(alpha == 5 ? "settle to 1e-4, cold, alpha 5" : "settle to 1e-4, cold, alpha 50",
                   cold);
  }
  print_settling("settle to 1e-4, a dab", median_settling(session, 1e-4, [&](int i) {
                   settle(session, 1e-6);
                   must_apply(session, stroke_on(prepared, i % 2 == 0 ? 2 : 0));
                 }));
  print_settling("settle to 1e-3, a curve of contrast 100",
                 median_settling(session, 1e-3, [&](int) {
                   must_apply(session, SetTransferCurve{TransferCurve(50)});
                   settle(session, 1e-6);
                   must_apply(session, SetTransferCurve{contrast_100()});
                 }));
}

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + std::ssize(numbers) / 2;
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// Prints the median of how long calls keep the device busy. `prepare` makes a change before each.
template <typename Prepare, typename Work>
void print_device_time(const char* what, Prepare&& prepare, Work&& work) {
  std::vector<double> times;
  for (int i = 0; i < kTraces; ++i) {
    prepare(i);
    times.push_back(microseconds_of(trace_device(work)));
  }
  std::printf("  device busy: %-39s %9.1f us\n", what, median(std::move(times)));
}

// Another α for all cells leaves the constraint unchanged. With another curve its change per slider
// step is gathered next to the matrices.
void print_metric_times(Solver& solver, Fields& fields) {
  const auto print = [&](const char* what, const TransferCurve& one, const TransferCurve& other) {
    print_device_time(
        what, [&](int i) { fields.set_transfer_curve(i % 2 == 0 ? one : other); },
        [&] { solver.set_metric(fields.view()); });
  };
  print("matrices, another alpha", TransferCurve(20), TransferCurve(20.1));
  print("matrices and constraint, another curve", TransferCurve::parse("-20:5,20:500").value(),
        TransferCurve::parse("-20:5,20:450").value());
}

/// Paints the first curve of the palette somewhere else each time.
void paint_curve(const PreparedMesh& prepared, int i, Fields& fields) {
  Stroke stroke = stroke_on(prepared, 0);
  stroke.brush.curve = 1;
  stroke.brush.strength = 0.5;
  stroke.path = {prepared.vertices[prepared.vertices.size() / (kTraces + 1) * i]};
  fields.paint(stroke);
}

// A dab of a palette's curve makes few matrices' rows anew.
void print_dab_time(const char* what, const TransferCurve& curve, const PreparedMesh& prepared,
                    Solver& solver) {
  Fields fields(prepared);
  fields.set_palette({{{"painted", 0, curve}}});
  solver.set_metric(fields.view());
  print_device_time(
      what, [&](int i) { paint_curve(prepared, i, fields); },
      [&] { solver.set_metric(fields.view()); });
}

// Does nothing without a trace. Each change follows a step, which clears the constraint from the
// caches.
Status print_device_times(const BenchSystem& system) {
  ASSIGN_OR_RETURN(const auto solver, Solver::create(system, {.backend = BackendKind::kCuda}));
  const PreparedMesh& prepared = *system.prepared;
  Fields fields(prepared);
  if (trace_device([&] { solver->set_metric(fields.view()); }).empty()) return solver->status();
  print_metric_times(*solver, fields);
  print_dab_time("matrices, a dab of another alpha", TransferCurve(20), prepared, *solver);
  print_dab_time("matrices, a dab of another curve", contrast_100(), prepared, *solver);
  solver->set_metric(fields.view());
  const auto constraint = [&] { solver->set_gradient_scale(fields.view()); };
  const auto print = [&](const char* what, auto&& change) {
    print_device_time(
        what,
        [&](int i) {
          solver->step();
          change(i);
        },
        constraint);
  };
  const auto slide = [&](int i) { fields.set_gradient_scale(0.3 + 0.01 * i); };
  const auto dab = [&](int i) {
    Stroke stroke = stroke_on(prepared, 0.1 * i);
    stroke.path = {prepared.vertices[prepared.vertices.size() / (kTraces + 1) * i]};
    fields.paint(stroke);
  };
  const auto paint_all = [&](int i) {
    Stroke stroke = stroke_on(prepared, 0.5 + 0.1 * i);
    stroke.brush.radius = 2 * prepared.statistics.diagonal();
    stroke.brush.strength = 0.5;
    fields.paint(stroke);
  };
  print("constraint, a slider", slide);
  print("constraint, a dab", dab);
  print("constraint, a slider beside paint", slide);
  print("constraint, paint on all cells", paint_all);
  print("constraint, a slider below it", slide);
  print("constraint, a dab on it", dab);
  return solver->status();
}

// Each thread steps its part of the sessions, like a scheduler with this many threads.
double step_all(std::span<const std::unique_ptr<Session>> sessions, size_t threads) {
  return median_milliseconds(5, 2, [&] {
    std::vector<std::jthread> workers;
    for (size_t t = 0; t < threads; ++t)
      workers.emplace_back([&, t] {
        for (size_t i = t; i < sessions.size(); i += threads) sessions[i]->step();
      });
  });
}

Status print_many(const BenchSystem& system, BackendKind backend) {
  std::vector<std::unique_ptr<Session>> sessions;
  for (int i = 0; i < kManySessions; ++i) {
    ASSIGN_OR_RETURN(auto session, open_session(system, backend));
    must_apply(*session, SetTransferCurve{TransferCurve(20 + i)});
    must_apply(*session, SetGradientScale{0});
    sessions.push_back(std::move(session));
  }
  for (const size_t threads : {1, 4, 8})
    std::printf("  %d sessions, a frame each, %zu threads %15.3f ms\n", kManySessions, threads,
                step_all(sessions, threads));
  return Status::ok();
}

Status print_scan(const BenchSystem& system, BackendKind backend) {
  ASSIGN_OR_RETURN(const auto session, open_session(system, backend));
  const FrameTimes times = measure_frames(*session, TransferCurve(50));
  const Solver& solver = session->solver();
  const double corners = median_milliseconds(9, 2, [&] { solver.displacement(); });
  const double vertices = median_milliseconds(9, 2, [&] { solver.vertex_displacement(); });
  RETURN_IF_ERROR(solver.status());
  std::printf("%s on %s: %d corners, %zu cells, %zu vertices\n", system.name.c_str(),
              std::string(solver.backend_name()).c_str(), system.corners(),
              system.prepared->cells.size(), system.prepared->vertices.size());
  std::printf("  frame, ms: solve %.3f, rhs %.3f, dab %.3f, matrix %.3f\n", times.solve, times.rhs,
              times.dab, times.matrix);
  std::printf("  read out, ms: corners %.3f, vertices evaluated %.3f\n", corners, vertices);
  std::printf("  bytes a corner: %.0f of the session",
              double(solver.byte_count()) / system.corners());
  if (cuda_memory_used() > 0)
    std::printf(", %.0f on the device with the mesh",
                double(cuda_memory_used()) / system.corners());
  std::printf("\n");
  print_settlings(*session);
  RETURN_IF_ERROR(solver.status());
  if (backend == BackendKind::kCpu) return Status::ok();
  if (system.corners() <= kCornersOfManyMax) RETURN_IF_ERROR(print_many(system, backend));
  return print_device_times(system);
}

Status run(BackendKind backend, std::span<char*> names) {
  for (const char* name : names) {
    ASSIGN_OR_RETURN(const ScanArgument scan, parse_scan(name));
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    ASSIGN_OR_RETURN(const BenchSystem system,
                     make_system(scan, mesh, depth_of(scan, mesh), kCornersMax));
    RETURN_IF_ERROR(print_scan(system, backend));
  }
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  const std::string_view backend = argc > 1 ? argv[1] : "";
  if (argc < 3 || (backend != "cpu" && backend != "cuda")) {
    std::cerr << "usage: device_bench cpu|cuda SCAN[@DEPTH]...\n";
    return 2;
  }
  const auto status =
      burnish::run(backend == "cpu" ? burnish::BackendKind::kCpu : burnish::BackendKind::kCuda,
                   {argv + 2, static_cast<size_t>(argc - 2)});
  if (status.is_ok()) return 0;
  std::cerr << "device_bench: " << status.message() << "\n";
  return 1;
}

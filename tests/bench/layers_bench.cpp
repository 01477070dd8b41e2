// The cost and the effect of the equaliser, the palette and kept edges. "layers": a gain's step and
// a dab of a curve, beside a solve frame and a whole new metric of the painted scan. An update is a
// frame without its cycle: fields, matrices and constraint. "edges": the whole filter, then frames
// of a drag of β without and with kept edges, of their strength, and of a dab of it, each until the
// displacement and the layer are there. "response": how much is left of a wave on a sphere when one
// band is silent, beside the formula. The wave is that of the coordinates, which are harmonics of
// order one.

#include <algorithm>
#include <numbers>
#include <vector>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/frames.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr int kFrames = 9;
constexpr double kDabRadius = 0.03;  // of the diagonal

Equaliser bands_of(const Session& session, double gain) {
  Equaliser equaliser;
  double size = 4 * session.prepared().frame.cell_size;
  for (size_t band = 0; band < kBandsMax; ++band, size *= 2) equaliser.bands.push_back({size, 1});
  equaliser.bands[2].gain = gain;
  return equaliser;
}

/// Returns the milliseconds of a gain's step, until the displacement of all corners is there.
double measure_gain(Session& session) {
  must_apply(session, SetEqualiser{bands_of(session, 1)});
  BURNISH_CHECK(session.solve({}).is_ok(), "the bands could not be solved");
  double gain = 1;
  return median_milliseconds(kFrames, 1, [&] {
    must_apply(session, SetEqualiser{bands_of(session, gain += 0.1)});
    session.update();
    session.displacement();
  });
}

/// Median milliseconds of a frame with an edit, and of its part before the cycle.
struct EditTimes {
  double update, frame;
};

template <typename Apply>
EditTimes measure_edit(Session& session, Apply&& apply) {
  std::vector<double> updates;
  EditTimes times{};
  times.frame = median_milliseconds(kFrames, 1, [&] {
    updates.push_back(milliseconds([&] {
      apply();
      session.update();
    }));
    session.step();
  });
  std::ranges::nth_element(updates, updates.begin() + kFrames / 2);
  times.update = updates[kFrames / 2];
  return times;
}

EditTimes measure_curve_dab(Session& session) {
  const PreparedMesh& prepared = session.prepared();
  must_apply(session, SetPalette{{{{"painted", 0, TransferCurve(20)}}}});
  Brush brush{.radius = kDabRadius * prepared.statistics.diagonal(), .strength = 0.5, .curve = 1};
  size_t vertex = 0;
  return measure_edit(session, [&] {
    vertex = (vertex + prepared.vertices.size() / kFrames) % prepared.vertices.size();
    must_apply(session, Stroke{brush, {prepared.vertices[vertex]}});
  });
}

EditTimes measure_whole_metric(Session& session) {
  double alpha = kAlphaDefault;
  return measure_edit(
      session, [&] { must_apply(session, SetTransferCurve{TransferCurve(alpha *= 0.999)}); });
}

Status measure(const BenchSystem& system, BackendKind backend, int threads, BenchTable& table) {
  ASSIGN_OR_RETURN(const auto session,
                   Session::open(system, {.backend = backend, .threads = threads}));
  must_apply(*session, SetGradientScale{0});
  BURNISH_CHECK(session->solve({}).is_ok(), "the session could not be solved");
  const double solve = median_milliseconds(kFrames, 1, [&] {
    session->step();
    session->displacement();
  });
  const double gain = measure_gain(*session);
  must_apply(*session, SetEqualiser{});
  const EditTimes dab = measure_curve_dab(*session), metric = measure_whole_metric(*session);
  table.add({system.name, std::string(session->solver().backend_name()),
             static_cast<double>(system.corners()), solve, gain, gain / solve, metric.frame,
             dab.frame, dab.frame / metric.frame, metric.update, dab.update,
             dab.update / metric.update});
  return session->status();
}

/// Shows a change as a drag does.
void drag(Session& session, PreviewChange change) {
  session.previews().show(1, {"", "drag", std::move(change)});
}

/// Returns the milliseconds of a frame with a change.
template <typename Apply>
double measure_frame(Session& session, Apply&& apply) {
  return median_milliseconds(kFrames, 1, [&] {
    apply();
    session.step();
    session.layer(session.displacement());
  });
}

double measure_slider(Session& session) {
  double beta = 0.5;
  return measure_frame(session, [&] { drag(session, SetGradientScale{beta += 0.01}); });
}

double measure_strength_dab(Session& session) {
  const PreparedMesh& prepared = session.prepared();
  const Brush brush{
      .radius = kDabRadius * prepared.statistics.diagonal(), .strength = 0.5, .edges = true};
  size_t vertex = 0;
  return measure_frame(session, [&] {
    vertex = (vertex + prepared.vertices.size() / kFrames) % prepared.vertices.size();
    must_apply(session, Stroke{brush, {prepared.vertices[vertex]}});
  });
}

Status measure_edges(const BenchSystem& system, BackendKind backend, int threads,
                     BenchTable& table) {
  ASSIGN_OR_RETURN(const auto session,
                   Session::open(system, {.backend = backend, .threads = threads}));
  const double plain = measure_slider(*session);
  SetEdges edges{find_edge_preset("scanner")->filter};
  must_apply(*session, edges);
  const double whole = milliseconds(
      [&] { BURNISH_CHECK(session->solve({.cycles = 1}).is_ok(), "edges could not be kept"); });
  const double beside = measure_slider(*session);
  const double strength = measure_frame(*session, [&] {
    edges.filter.strength -= 0.01;
    drag(*session, edges);
  });
  session->previews().drop(1);
  const double dab = measure_strength_dab(*session);
  table.add({system.name, std::string(session->solver().backend_name()),
             static_cast<double>(system.prepared->triangles.size()), 1e-3 * whole, plain, beside,
             strength, dab});
  return session->status();
}

/// Returns the mean radius of a sphere of radius 1 with this equaliser.
Result<double> mean_radius(Session& session, const Equaliser& equaliser) {
  must_apply(session, SetEqualiser{equaliser});
  RETURN_IF_ERROR(session.solve({.exact = true}).status());
  const TriangleMesh moved = session.surface();
  double sum = 0;
  for (const Vec3d& vertex : moved.vertices) sum += vertex.norm();
  return sum / static_cast<double>(moved.vertices.size());
}

// The coordinates are one wave, so the bands change their sizes and the wave stays.
Status report_response(BenchTable& table) {
  constexpr int kLevel = 5, kDepth = 6;
  const double wavelength = 2 * std::numbers::pi / std::numbers::sqrt2;
  PrepareOptions options;
  options.depth = kDepth;
  ASSIGN_OR_RETURN(const auto prepared, prepare(make_icosphere(kLevel, 1), options));
  ASSIGN_OR_RETURN(const auto multigrid, make_multigrid(prepared, {}));
  ASSIGN_OR_RETURN(const auto session, Session::open(multigrid, {.backend = BackendKind::kCpu}));
  for (const double scale : {0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 20.0})
    for (size_t silent = 0; silent < 3; ++silent) {
      Equaliser equaliser{{{0.4 * scale, 1}, {scale, 1}, {2.5 * scale, 1}}};
      equaliser.bands[silent].gain = 0;
      ASSIGN_OR_RETURN(const double found, mean_radius(*session, equaliser));
      table.add({static_cast<double>(silent + 1), wavelength / scale, found,
                 response(equaliser, wavelength)});
    }
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& table = report.add_table("layers", {{"scan", "", 26},
                                                  {"on", "", 5},
                                                  {"corners", "%.0f", 9},
                                                  {"solve_ms"},
                                                  {"gain_ms"},
                                                  {"gain_of_solve"},
                                                  {"metric_ms"},
                                                  {"curve_dab_ms"},
                                                  {"dab_of_metric"},
                                                  {"metric_update_ms"},
                                                  {"dab_update_ms"},
                                                  {"dab_of_update"}});
  BenchTable& edges = report.add_table("edges", {{"scan", "", 26},
                                                 {"on", "", 5},
                                                 {"triangles", "%.0f", 9},
                                                 {"filter_s"},
                                                 {"slider_ms"},
                                                 {"slider_beside_ms"},
                                                 {"strength_ms"},
                                                 {"dab_ms"}});
  for (const ScanArgument& scan : arguments.scans) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    ASSIGN_OR_RETURN(const auto system,
                     system_or_remark(scan, mesh, depth_of(scan, mesh), arguments, report));
    if (!system) continue;
    RETURN_IF_ERROR(measure(*system, BackendKind::kCpu, arguments.threads, table));
    RETURN_IF_ERROR(measure_edges(*system, BackendKind::kCpu, arguments.threads, edges));
    if (!cuda_device().is_ok()) continue;
    RETURN_IF_ERROR(measure(*system, BackendKind::kCuda, arguments.threads, table));
    RETURN_IF_ERROR(measure_edges(*system, BackendKind::kCuda, arguments.threads, edges));
  }
  return report_response(report.add_table(
      "response", {{"silent_band"}, {"wavelength"}, {"found", "%.5f"}, {"formula", "%.5f"}}));
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"layers_bench", {"tablet:250000@8"}, burnish::run}, argc, argv);
}

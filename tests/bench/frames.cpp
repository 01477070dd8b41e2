#include "tests/bench/frames.h"

#include <algorithm>
#include <utility>

#include "tests/bench/clock.h"
#include "tests/bench/timing.h"

namespace burnish {

static constexpr int kFrames = 9;
static constexpr int kWarmUp = 1;
static constexpr double kDabRadius = 0.03;  // of the diagonal

// Returns a slightly different curve: setting the same curve again is not an edit.
static TransferCurve nudged(const TransferCurve& curve) {
  auto points = curve.points();
  for (auto& point : points) point.alpha *= 0.999;
  return TransferCurve::create(std::move(points)).value();
}

FrameTimes measure_frames(Session& session, const TransferCurve& curve) {
  must_apply(session, SetTransferCurve{curve});
  must_apply(session, SetGradientScale{0});
  FrameTimes times;
  times.gigahertz = core_gigahertz();
  const auto median_of = [&](int frames, int warm_up, auto&& frame) {
    const double median = median_milliseconds(frames, warm_up, frame);
    times.gigahertz = std::min(times.gigahertz, core_gigahertz());
    return median;
  };
  times.solve = median_of(kFrames, 2 * kWarmUp, [&] { session.step(); });
  double beta = 0;
  times.rhs = median_of(kFrames, kWarmUp, [&] {
    must_apply(session, SetGradientScale{beta += 0.01});
    session.step();
  });
  const PreparedMesh& prepared = session.prepared();
  const Brush brush = {.radius = kDabRadius * prepared.statistics.diagonal(), .strength = 0.5};
  size_t vertex = 0;
  times.dab = median_of(kFrames, kWarmUp, [&] {
    vertex = (vertex + prepared.vertices.size() / kFrames) % prepared.vertices.size();
    must_apply(session, Stroke{brush, {prepared.vertices[vertex]}});
    session.step();
  });
  TransferCurve now = nudged(curve), next = curve;
  times.matrix = median_of(kFrames, kWarmUp, [&] {
    must_apply(session, SetTransferCurve{now});
    session.step();
    std::swap(now, next);
  });
  must_apply(session, SetTransferCurve{curve});
  times.evaluate = median_of(kFrames, kWarmUp, [&] { session.solver().evaluate_vertices(); });
  return times;
}

}  // namespace burnish

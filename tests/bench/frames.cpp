#include "tests/bench/frames.h"

#include "tests/bench/timing.h"

namespace burnish {

static constexpr int kFrames = 9;
static constexpr int kWarmUp = 1;

FrameTimes measure_frames(Session& session, const TransferCurve& curve) {
  must_apply(session, SetTransferCurve{curve});
  must_apply(session, SetGradientScale{0});
  FrameTimes times;
  times.solve = median_milliseconds(kFrames, 2 * kWarmUp, [&] { session.step(); });
  double beta = 0;
  times.rhs = median_milliseconds(kFrames, kWarmUp, [&] {
    must_apply(session, SetGradientScale{beta += 0.01});
    session.step();
  });
  times.matrix = median_milliseconds(kFrames, kWarmUp, [&] {
    must_apply(session, SetTransferCurve{curve});
    session.step();
  });
  times.evaluate =
      median_milliseconds(kFrames, kWarmUp, [&] { session.solver().evaluate_vertices(); });
  return times;
}

}  // namespace burnish

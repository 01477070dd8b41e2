#include "server/memory/memory_need.h"

#include <gtest/gtest.h>

#include "common/frame_codec/frame_encoder.h"
#include "common/generate/generate.h"
#include "server/live/frame_target.h"
#include "server/memory/opening_need.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {
namespace {

class MemoryNeed : public testing::TestWithParam<int> {};

TEST_P(MemoryNeed, IsNoLessThanWhatIsTakenAndNotFarAbove) {
  const int depth = GetParam();
  const auto prepared = prepare(make_icosphere(5, 1), {depth, 0, 1}, {}).value();
  const Multigrid multigrid = make_multigrid(prepared).value();
  const auto session =
      std::move(Session::open(multigrid, {BackendKind::kCpu, Smoother::kSchwarz, 1})).value();
  ASSERT_TRUE(session->apply({"a", SetTransferCurve{TransferCurve(5)}}).is_ok());
  session->previews().show(1, {"ann", "b", SetGradientScale{0.5}});
  session->update();
  session->step();
  const double mesh = static_cast<double>(multigrid.byte_count());
  const double own = static_cast<double>(session->byte_count());
  EXPECT_GE(static_cast<double>(predict_mesh_bytes(*prepared)), mesh);
  EXPECT_LE(static_cast<double>(predict_mesh_bytes(*prepared)), 1.5 * mesh);
  EXPECT_GE(static_cast<double>(predict_session_bytes(multigrid)), own);
  EXPECT_LE(static_cast<double>(predict_session_bytes(multigrid)), 2 * own + (8 << 20));
}

TEST_P(MemoryNeed, OfFramesIsNoLessThanTheirLayoutAndPoints) {
  const auto prepared = prepare(make_icosphere(5, 1), {GetParam(), 0, 1}, {}).value();
  const auto shared = std::make_shared<const SharedMesh>(make_multigrid(prepared).value());
  Quota memory("bytes", "max", UINT64_MAX);
  FrameTargets targets(memory);
  for (const uint64_t triangles_max : {0, 2000})
    for (const FrameContent content : {FrameContent::kCoefficients, FrameContent::kVertices}) {
      const auto target = targets.find_or_make(shared, triangles_max, content, {}).value();
      const uint64_t taken =
          target->layout->byte_count() + target->proxy_points.size() * sizeof(EvaluationPoint);
      EXPECT_GE(predict_target_bytes(*prepared, *shared->hierarchy, triangles_max), taken);
      EXPECT_EQ(memory.taken(), target->memory.amount());
    }
}

TEST_P(MemoryNeed, OfAClientIsNoLessThanItsEncoderHoldsAndLessThanTwiceThat) {
  const auto prepared = prepare(make_icosphere(5, 1), {GetParam(), 0, 1}, {}).value();
  const auto shared = std::make_shared<const SharedMesh>(make_multigrid(prepared).value());
  Quota memory("bytes", "max", UINT64_MAX);
  const auto target = FrameTargets(memory).find_or_make(shared, 0, {}, {}).value();
  FrameEncoder encoder(target->layout);
  FrameSample sample;
  for (int i = 1; i <= 20; ++i) {
    sample.steps.assign(size_t{3} * target->layout->value_count(), 100 * i);
    const EncodedFrame frame = encoder.encode(sample, FrameStep::kMoving);
    if (i <= 2) encoder.acknowledge(frame.sequence);
  }
  EXPECT_GE(predict_client_bytes(*target->layout), encoder.byte_count());
  EXPECT_LE(predict_client_bytes(*target->layout), 2 * encoder.byte_count());
}

/// Records the need of a preparation.
class RecordingBudget final : public PreparationBudget {
 public:
  uint64_t memory_bytes_max() const override { return UINT64_MAX / 2; }
  Status ask(const PreparationNeed& need) override {
    last = need;
    return Status::ok();
  }
  PreparationNeed last;
};

TEST(OpenedMemoryNeed, RefusesNobodyWhoCouldOpenASession) {
  for (const char* kind : {"blob", "sheet", "tablet", "soup", "fan", "part"})
    for (const int depth : {5, 7}) {
      RecordingBudget budget;
      const TriangleMesh mesh = generate_scan({kind, 20000, 1}).value();
      const auto prepared = prepare(mesh, {depth, 0, 0, &budget}, {}).value();
      const Multigrid multigrid = make_multigrid(prepared).value();
      const uint64_t predicted = predict_opened_bytes(budget.last);
      const uint64_t admitted = predict_mesh_bytes(*prepared) + predict_session_bytes(multigrid);
      EXPECT_LE(predicted, admitted) << kind << " at depth " << depth;
      EXPECT_GE(2 * predicted, admitted - (6 << 20)) << kind << " at depth " << depth;
    }
}

INSTANTIATE_TEST_SUITE_P(Depths, MemoryNeed, testing::Values(4, 6, 8));

}  // namespace
}  // namespace burnish

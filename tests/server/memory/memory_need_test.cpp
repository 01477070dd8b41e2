#include "server/memory/memory_need.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/page_frames/page_evaluation.h"
#include "common/page_frames/page_frame_encoder.h"
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
  EXPECT_GE(static_cast<double>(predict_mesh_bytes(*prepared, PreparedPlace::kMemory)), mesh);
  EXPECT_LE(static_cast<double>(predict_mesh_bytes(*prepared, PreparedPlace::kMemory)), 1.5 * mesh);
  EXPECT_GE(static_cast<double>(predict_session_bytes(multigrid)), own);
  EXPECT_LE(static_cast<double>(predict_session_bytes(multigrid)), 2 * own + (8 << 20));
}

TEST_P(MemoryNeed, OfAClientIsNoLessThanItsEncoderHoldsAndLessThanTwiceThat) {
  const auto prepared = prepare(make_icosphere(5, 1), {GetParam(), 0, 1}, {}).value();
  const SparseGrid grid = make_finest_grid(GetParam(), prepared->cells);
  Page page;  // the vertices of a page, in a row
  for (int x = 0; x < 2000; ++x) page.positions.push_back({x << 10, 1 << 20, 1 << 20});
  const PageEvaluation made =
      make_page_evaluation(page, kPageGridBitsMax, grid, PageFrameKind::kVertices);
  const ShownPages shown = ShownPages().changed({1, {made.shown}, {}});
  PageFrameEncoder encoder(PageFrameKind::kVertices);
  for (int i = 1; i <= 20; ++i) {
    const std::vector<int32_t> steps(size_t{3} * made.shown.value_count(), 100 * i);
    const WantedPage wanted{steps};
    const EncodedPageFrame frame = encoder.encode({shown, {&wanted, 1}}, kStillSteps);
    if (i <= 2) encoder.acknowledge(frame.sequence);
  }
  EXPECT_GE(predict_client_bytes(shown.pages()), encoder.byte_count());
  EXPECT_LE(predict_client_bytes(shown.pages()), 2 * encoder.byte_count());
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

TEST(SessionNeed, OnADeviceIsThatOfFieldsAndPicturesOnTheHost) {
  const auto prepared = prepare(make_icosphere(6, 1), {8, 0, 1}, {}).value();
  const Multigrid on = make_multigrid(prepared).value();
  const SessionNeed here = predict_session_need(on, 0), there = predict_session_need(on, 1);
  EXPECT_EQ(here.open, predict_session_bytes(on));
  EXPECT_EQ(here.opening, here.open);
  EXPECT_EQ(there.opening, there.open);
  EXPECT_LT(there.open, here.open / 4);
}

TEST(SessionNeed, OnSeveralDevicesIsTheScanOnceMoreWhileItOpens) {
  const auto prepared = prepare(make_icosphere(5, 1), {7, 0, 1}, {}).value();
  const Multigrid on = make_multigrid(prepared).value();
  const SessionNeed need = predict_session_need(on, 2);
  EXPECT_EQ(need.opening, need.open + on.hierarchy->byte_count() + prepared->byte_count());
  EXPECT_LT(need.open, predict_session_bytes(on) / 3);
}

TEST(OpenedMemoryNeed, OfAScanThatDevicesHaveRoomForIsThatOfTheHostAlone) {
  RecordingBudget budget;
  ASSERT_TRUE(prepare(make_icosphere(5, 1), {7, 0, 1, &budget}, {}).is_ok());
  const uint64_t here = predict_opened_bytes(budget.last, 1 << 20);
  EXPECT_EQ(here, predict_opened_bytes(budget.last, 0));
  EXPECT_LT(predict_opened_bytes(budget.last, uint64_t{1} << 33), 2 * here / 3);
}

TEST(OpenedMemoryNeed, RefusesNobodyWhoCouldOpenASession) {
  for (const char* kind : {"blob", "sheet", "tablet", "soup", "fan", "part"})
    for (const int depth : {5, 7}) {
      RecordingBudget budget;
      const TriangleMesh mesh = generate_scan({kind, 20000, 1}).value();
      const auto prepared = prepare(mesh, {depth, 0, 0, &budget}, {}).value();
      const Multigrid multigrid = make_multigrid(prepared).value();
      const uint64_t predicted = predict_opened_bytes(budget.last, 0);
      const uint64_t admitted =
          predict_mesh_bytes(*prepared, place_of_prepared(prepared->byte_count())) +
          predict_session_bytes(multigrid);
      EXPECT_LE(predicted, admitted) << kind << " at depth " << depth;
      EXPECT_GE(2 * predicted, admitted - (6 << 20)) << kind << " at depth " << depth;
    }
}

INSTANTIATE_TEST_SUITE_P(Depths, MemoryNeed, testing::Values(4, 6, 8));

}  // namespace
}  // namespace burnish

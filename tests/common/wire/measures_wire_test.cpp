#include "common/wire/measures_wire.h"

#include <gtest/gtest.h>

#include "common/wire/session_wire.h"

namespace burnish {
namespace {

SessionDeviation some_deviation() {
  SessionDeviation measured;
  measured.settled = true;
  measured.deviation.max = 0.5;
  measured.deviation.farthest = {1, 2, 3};
  measured.deviation.volume_after = 7;
  measured.deviation.histogram[63] = 0.25;
  measured.deviation.axes = std::array<AxisMoves, 3>{{{}, {-1, 2, 0.5, 0.75}, {}}};
  return measured;
}

TEST(MeasuresWire, DeviationArrivesAsItWasSent) {
  const auto arrived = from_wire(to_wire(some_deviation()));
  ASSERT_TRUE(arrived.is_ok());
  EXPECT_TRUE(arrived->settled);
  EXPECT_EQ(arrived->deviation.max, 0.5);
  EXPECT_EQ(arrived->deviation.farthest, Vec3d(1, 2, 3));
  EXPECT_EQ(arrived->deviation.volume_after, 7);
  EXPECT_EQ(arrived->deviation.histogram, some_deviation().deviation.histogram);
}

TEST(MeasuresWire, MovesAlongAxesArriveAndAnOlderServerHasNone) {
  v1::Deviation message = to_wire(some_deviation());
  const AxisMoves moves = (*from_wire(message)->deviation.axes)[1];
  EXPECT_EQ(moves.least, -1);
  EXPECT_EQ(moves.most, 2);
  EXPECT_EQ(moves.mean, 0.5);
  EXPECT_EQ(moves.rms, 0.75);
  message.mutable_axes()->RemoveLast();
  EXPECT_EQ(from_wire(message).status().code(), StatusCode::kDataLoss);
  message.clear_axes();
  EXPECT_FALSE(from_wire(message)->deviation.axes.has_value());
}

TEST(MeasuresWire, DeviationWithOtherBinsIsDamaged) {
  v1::Deviation message = to_wire(some_deviation());
  message.add_histogram(0.5);
  EXPECT_EQ(from_wire(message).status().code(), StatusCode::kDataLoss);
}

TEST(MeasuresWire, SectionArrivesAsItWasSent) {
  const Section section = {{{{{0, 0}, {1, 0.5}}}}, {{{{0, 0}, {2, 1}, {0, 0}}}}};
  const auto arrived = from_wire(to_wire(section, Plane{}));
  ASSERT_TRUE(arrived.is_ok());
  ASSERT_EQ(arrived->original.size(), 1u);
  EXPECT_EQ(arrived->original[0].points, section.original[0].points);
  EXPECT_TRUE(arrived->edited[0].is_closed());
}

TEST(MeasuresWire, SectionOfHalfAPointIsDamaged) {
  v1::Section message;
  for (const float x : {1.0f, 2.0f, 3.0f}) message.add_edited()->add_points(x);
  EXPECT_EQ(from_wire(message).status().code(), StatusCode::kDataLoss);
}

TEST(MeasuresWire, PlaneWithoutADirectionIsRefused) {
  v1::GetSectionRequest request;
  request.set_session("work");
  EXPECT_EQ(from_wire(request).status().code(), StatusCode::kInvalidArgument);
  request.mutable_direction()->set_y(-4);
  EXPECT_EQ(from_wire(request)->plane.normal, Vec3d(0, -1, 0));
}

TEST(MeasuresWire, ExportSummaryCarriesADeviationThatWasAskedFor) {
  ExportSummary summary;
  EXPECT_FALSE(from_wire(to_wire(summary))->deviation);
  summary.deviation = some_deviation().deviation;
  summary.edits = 4;
  EXPECT_EQ(from_wire(to_wire(summary))->deviation->max, 0.5);
  EXPECT_EQ(from_wire(to_wire(summary))->edits, 4u);
}

}  // namespace
}  // namespace burnish

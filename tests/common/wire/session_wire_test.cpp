#include "common/wire/session_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(SessionWire, ASummaryNamesWhatIsLeftOut) {
  ExportSummary summary;
  summary.left_out = {"normals", "materials"};
  EXPECT_EQ(from_wire(to_wire(summary))->left_out, summary.left_out);
}

TEST(SessionWire, ASummarySaysHowMuchOfTheVolumeThereIsAndWhy) {
  ExportSummary summary;
  summary.volume = 0.75;
  summary.lost_volume = "the volume is 75 %";
  summary.pictures = "1 of 2 pictures changed, 30 texels";
  const ExportSummary arrived = from_wire(to_wire(summary)).value();
  EXPECT_EQ(arrived.volume, 0.75);
  EXPECT_EQ(arrived.lost_volume, summary.lost_volume);
  EXPECT_EQ(arrived.pictures, summary.pictures);
}

TEST(SessionWire, ExportCyclesHaveLimits) {
  v1::ExportRequest message;
  message.set_format(v1::MESH_FORMAT_PLY);
  for (const int cycles : {0, -1, 10'001}) {
    message.set_cycles(cycles);
    EXPECT_THAT(from_wire(message).status().message(), HasSubstr("outside 1..10000"));
  }
  message.set_cycles(3);
  EXPECT_EQ(from_wire(message).value().cycles, 3);
}

TEST(SessionWire, AWishForAnExportComesBackUnchanged) {
  const ExportWish exact = from_wire(to_wire("s", ExportWish{MeshFormat::kObj, true, 0})).value();
  EXPECT_TRUE(exact.exact);
  EXPECT_EQ(exact.format, MeshFormat::kObj);
  const ExportWish settled = from_wire(to_wire("s", ExportWish{})).value();
  EXPECT_FALSE(settled.exact);
  EXPECT_EQ(settled.cycles, 0);
}

TEST(SessionWire, AStateComesBackUnchanged) {
  SessionState state;
  state.session = {"id", "name", std::string(64, 'a'), {8, 0}, 17, 3, true};
  state.settings.beta = 0.5;
  state.settings.curve = *TransferCurve::create({{-5, 10}, {5, 100}});
  state.cycles = 4;
  state.backend = "cpu";
  state.rims = 5;
  state.rims_held = 4;
  state.walls = {0.25, 9};
  const auto back = from_wire(to_wire(state));
  ASSERT_TRUE(back.is_ok());
  EXPECT_EQ(to_wire(back.value()).SerializeAsString(), to_wire(state).SerializeAsString());
  EXPECT_EQ(back.value().settings.curve, state.settings.curve);
  EXPECT_EQ(back.value().rims, 5);
  EXPECT_EQ(back.value().rims_held, 4);
  EXPECT_EQ(back.value().walls.share, 0.25);
  EXPECT_EQ(back.value().walls.depth, 9);
}

TEST(SessionWire, ASessionNeedsAScan) {
  EXPECT_THAT(from_wire(v1::OpenSessionRequest()).status().message(), HasSubstr("scan"));
}

}  // namespace
}  // namespace burnish

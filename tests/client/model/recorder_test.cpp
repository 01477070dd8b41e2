#include "client/model/documents/recorder.h"

#include <fstream>

#include <gtest/gtest.h>

#include "common/base/parse_number.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

TEST(Recorder, EveryEditThatAWindowMakesHasALine) {
  const TemporaryFolder folder;
  const auto path = folder / "record.txt";
  Recorder recorder;
  ASSERT_TRUE(recorder.open(path).is_ok());
  recorder.record(Edit{"1", SetGradientScale{0.5}});
  recorder.record(Edit{"2", SetTransferCurve{*TransferCurve::parse("-1:5,2:50")}});
  recorder.record(Edit{"3", Stroke{{.radius = 2, .strength = 0.5, .beta = 0}, {Vec3d(1, 2, 3)}}});
  recorder.record(Edit{"3", Stroke{{.radius = 2, .beta = 0, .connected = true}, {Vec3d(1, 2, 3)}}});
  recorder.record(Edit{"4", Undo{}});
  recorder.record(Edit{"5", SwitchEntry{3, true}});
  recorder.record(Edit{"6", SetCheckpoint{"first draft"}});
  recorder.record(Edit{"7", SetEdges{{0.5, NormalFilterKind::kEdges, 20, 3, 0.25}}});
  std::ifstream file(path);
  const std::string lines{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(lines,
            "beta 0.5\ncurve -1:5,2:50\nstroke 2 0.5 0 smooth through 1 2 3\n"
            "stroke 2 1 0 smooth 1 2 3\nundo\nswitch 3 on\n"
            "checkpoint first draft\nedges edges 0.5 20 3 0.25\n");
}

TEST(Recorder, NumbersAreReadBackAsTheyWere) {
  std::string line;
  Recorder recorder;
  recorder.open([&](const std::string& recorded) { line = recorded; });
  recorder.record(Edit{"1", SetGradientScale{1.0 / 3}});
  EXPECT_EQ(parse_number<double>(line.substr(5)), 1.0 / 3) << line;
}

TEST(Recorder, WithoutAFileNothingHappens) {
  Recorder recorder;
  recorder.record("undo");
  EXPECT_EQ(recorder.open("/nonexistent/record.txt").code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish

#include "common/wire/edit_wire.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/edit/edit_lines.h"
#include "common/edit/preview_change.h"
#include "common/wire/edit_bytes.h"

namespace burnish {
namespace {

using testing::HasSubstr;

v1::Edit with_id() {
  v1::Edit message;
  message.set_id("e1");
  return message;
}

v1::Edit stroke_message() {
  v1::Edit message = with_id();
  v1::Brush* brush = message.mutable_stroke()->mutable_brush();
  brush->set_radius(0.5);
  brush->set_strength(1);
  brush->set_beta(2);
  brush->set_fall_off(v1::FALL_OFF_SHARP);
  message.mutable_stroke()->add_path()->set_x(1);
  return message;
}

std::string refusal(const v1::Edit& message) {
  const auto edit = from_wire(message);
  return edit.is_ok() ? "accepted" : edit.status().message();
}

TEST(EditWire, LayersBeyondTheirLimitsAreRefused) {
  v1::Edit message = stroke_message();
  message.mutable_stroke()->mutable_brush()->set_band(7);
  EXPECT_THAT(refusal(message), HasSubstr("band 7, the limit is 0 to 6"));
  message.mutable_stroke()->mutable_brush()->set_band(0xffffffff);
  EXPECT_THAT(refusal(message), HasSubstr("band 2147483647"));
  v1::Edit bands = with_id();
  for (int i = 0; i < 7; ++i) bands.mutable_equaliser()->add_bands()->set_size(i + 1);
  EXPECT_THAT(refusal(bands), HasSubstr("7 bands: the limit is 6"));
  v1::Edit palette = with_id();
  palette.mutable_palette()->add_curves()->set_name("a");
  EXPECT_THAT(refusal(palette), HasSubstr("curve 1: "));
}

TEST(EditWire, EveryKindOfChangeComesBackUnchangedFromBytes) {
  const TransferCurve curve = *TransferCurve::create({{-20, 5}, {0, 50}, {7.25, 100}});
  const std::vector<Edit> edits = {
      {"a", SetGradientScale{0.25}},
      {"b", SetTransferCurve{curve}},
      {"c", Stroke{{0.5, 0.75, 2, FallOff::kLinear}, {Vec3d(1, 2, 3), Vec3d(-4, 5e-9, 6)}}},
      {"d", SetCellFields{{{Vec3i(1, 2, 3), 5, 6, 0.5}, {Vec3i(7, 8, 9), 10, 10, 3}}}},
      {"e", Undo{}},
      {"f", Redo{}},
      {"g", SwitchEntry{7, true}},
      {"h", SetCheckpoint{"before"}},
      {"i", RestoreCheckpoint{"before"}},
      {"k", Protect{CurvatureRegion{-3, 4.5}}},
      {"l", Protect{PieceRegion{Vec3d(1, 2, 3)}, true}},
      {"m", Protect{GrownRegion{-7}}},
      {"n", Protect{InvertedRegion{}}},
      {"o", Protect{NoRegion{}}},
      {"p", Protect{LassoRegion{{1, 2, 3}, {{0, 0}, {0.5, 0}, {0, 0.25}}, true}}},
      {"q", SetEqualiser{{{{0.25, 2}, {0.5, 0}}}}},
      {"r", SetPalette{{{{"letters", 0xd04040, curve}, {"ground", 0, TransferCurve(9)}}}}},
      {"s", Stroke{{0.5, 0.75, 2, FallOff::kSharp, 3, 0}, {Vec3d(1, 2, 3)}}},
      {"t", Stroke{{0.5, 0.75, 2, FallOff::kSharp, 0, 8}, {Vec3d(1, 2, 3)}}},
      {"u", SetColour{{7, 0.25}}},
      {"v", Stroke{{0.5, 0.75, 2, FallOff::kSharp, 0, 0, true}, {Vec3d(1, 2, 3)}}},
      {"w", Stroke{{.radius = 0.5, .beta = 2, .connected = true}, {Vec3d(1, 2, 3)}}},
      {"x", Stroke{{.radius = 0.5, .beta = 2, .texture = true}, {Vec3d(1, 2, 3)}}},
      {"x", SetEdges{{0.5, NormalFilterKind::kEdges, 40, 7, 0.25}}},
      {"y", SetTexture{{0, 0.75, 0.5}}},
      {"z", SetCellFields{{{Vec3i(1, 2, 3), 0, 0, 0.5}}, CellTarget::kEdges}},
      {"0", SetCellFields{{{Vec3i(1, 2, 3), 0, 0, 1}}, CellTarget::kProtection}},
      {"1", SetCellFields{{{Vec3i(1, 2, 3), 0, 0, 2.5}}, CellTarget::kTexture}},
      {"j", SetControls{{.pin_rims = true, .cap = 0.25, .keep_volume = true}}},
  };
  for (const Edit& edit : edits) {
    const auto back = edit_from_bytes(edit_to_bytes(edit));
    ASSERT_TRUE(back.is_ok()) << back.status().message();
    EXPECT_EQ(back.value().id, edit.id);
    EXPECT_EQ(back.value().change.index(), edit.change.index());
    EXPECT_EQ(edit_to_bytes(back.value()), edit_to_bytes(edit));
  }
  const auto stroke = std::get<Stroke>(edit_from_bytes(edit_to_bytes(edits[2])).value().change);
  EXPECT_EQ(stroke.brush.fall_off, FallOff::kLinear);
  EXPECT_EQ(stroke.path[1], Vec3d(-4, 5e-9, 6));
  EXPECT_EQ(
      std::get<SetTransferCurve>(edit_from_bytes(edit_to_bytes(edits[1])).value().change).curve,
      curve);
}

TEST(EditWire, EverySettingComesBackFromAnEditAndFromAGesture) {
  for (const Change& change : changes_that_make({.beta = 0.25, .colour = {.beta = 0.5}})) {
    const Edit edit{"e1", change};
    SCOPED_TRACE(edit_kind_name(kind_of(edit)));
    const auto came_back = from_wire(to_wire(edit));
    ASSERT_TRUE(came_back.is_ok()) << came_back.status().to_string();
    EXPECT_EQ(line_of(came_back->change), line_of(change));
    const auto shown = preview_of(change);
    if (!shown) continue;
    v1::Preview message;
    message.set_edit_id("e1");
    write_preview(*shown, message);
    const auto gesture = from_wire(message);
    ASSERT_TRUE(gesture.is_ok()) << gesture.status().to_string();
    EXPECT_EQ(line_of(gesture->change), line_of(change));
  }
}

TEST(EditWire, StrokesOfEarlierVersionsPaintThroughWallsAndKeepTheirBytes) {
  Edit edit{"a", Stroke{{.radius = 0.5, .beta = 2}, {Vec3d(1, 2, 3)}}};
  const std::string bytes = edit_to_bytes(edit);
  EXPECT_EQ(bytes.size(), 65u);  // as 0.1.0 wrote it
  const auto is_connected = [](const std::string& stored) {
    return std::get<Stroke>(edit_from_bytes(stored).value().change).brush.connected;
  };
  EXPECT_FALSE(is_connected(bytes));
  std::get<Stroke>(edit.change).brush.connected = true;
  EXPECT_EQ(edit_to_bytes(edit).size(), bytes.size() + 2);
  EXPECT_TRUE(is_connected(edit_to_bytes(edit)));
}

TEST(EditWire, TheCapOfControlsIsChecked) {
  v1::Edit message = with_id();
  message.mutable_controls()->set_cap(-0.5);
  EXPECT_THAT(refusal(message), testing::AllOf(HasSubstr("cap -0.5"), HasSubstr("1e+18")));
  message.mutable_controls()->set_cap(std::nan(""));
  EXPECT_THAT(refusal(message), HasSubstr("cap nan"));
  message.mutable_controls()->set_cap(2);
  message.mutable_controls()->set_pin_rims(true);
  EXPECT_EQ(std::get<SetControls>(from_wire(message).value().change).controls,
            (Controls{.pin_rims = true, .cap = 2}));
}

TEST(EditWire, KeptEdgesAreChecked) {
  v1::Edit message = with_id();
  v1::EdgeFilter& edges = *message.mutable_edges();
  edges.set_edge_angle(35);
  edges.set_passes(0xffffffff);
  EXPECT_THAT(refusal(message), HasSubstr("edges: passes 2147483647 is outside 1..100"));
  edges.set_passes(5);
  EXPECT_EQ(refusal(message), "accepted");
  edges.set_strength(1.5);
  EXPECT_THAT(refusal(message), HasSubstr("edges: strength 1.5 is outside 0..1"));
  edges.set_kind(static_cast<v1::NormalFilterKind>(9));
  EXPECT_THAT(refusal(message), HasSubstr("filter of normals 9 is none of"));
}

TEST(EditWire, AProtectedRegionIsChecked) {
  v1::Edit message = with_id();
  EXPECT_THAT((message.mutable_protect(), refusal(message)), HasSubstr("no way"));
  message.mutable_protect()->set_grow(65);
  EXPECT_THAT(refusal(message), testing::AllOf(HasSubstr("65"), HasSubstr("64")));
  v1::Lasso& lasso = *message.mutable_protect()->mutable_lasso();
  EXPECT_THAT(refusal(message), HasSubstr("0 numbers, not 16"));
  for (int i = 0; i < 16; ++i) lasso.add_view_projection(i);
  for (int i = 0; i < 5; ++i) lasso.add_points(i);
  EXPECT_THAT(refusal(message), HasSubstr("5 coordinates"));
  lasso.add_points(1);
  EXPECT_EQ(refusal(message), "accepted");
  lasso.set_view_projection(3, std::nan(""));
  EXPECT_THAT(refusal(message), HasSubstr("nan"));
}

TEST(EditWire, DamagedBytesAreDataLoss) {
  EXPECT_EQ(edit_from_bytes("\x12\xff\xff").status().code(), StatusCode::kDataLoss);
}

TEST(EditWire, AnEditWithoutAChangeIsRefused) {
  EXPECT_THAT(refusal(with_id()), HasSubstr("edit e1: "));
}

TEST(EditWire, IdsAreShortPrintableAndNotEmpty) {
  v1::Edit message;
  message.mutable_gradient_scale()->set_beta(1);
  EXPECT_THAT(refusal(message), HasSubstr("0 bytes"));
  message.set_id(std::string(65, 'x'));
  EXPECT_THAT(refusal(message), HasSubstr("65 bytes"));
  message.set_id("a b");
  EXPECT_THAT(refusal(message), HasSubstr("printable"));
  message.set_id(std::string(64, 'x'));
  EXPECT_EQ(refusal(message), "accepted");
}

TEST(EditWire, BetaOutsideItsLimitsIsRefusedWithValueAndLimit) {
  for (const double beta : {-0.1, 10.5, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    v1::Edit message = with_id();
    message.mutable_gradient_scale()->set_beta(beta);
    EXPECT_THAT(refusal(message), HasSubstr("outside 0..10"));
  }
}

TEST(EditWire, CurvePointsMustRiseAndStayWithinTheirLimits) {
  v1::Edit message = with_id();
  EXPECT_THAT((message.mutable_transfer_curve(), refusal(message)), HasSubstr("1 to 64 points"));
  message.mutable_transfer_curve()->add_points()->set_alpha(5);
  message.mutable_transfer_curve()->add_points()->set_alpha(6);
  EXPECT_THAT(refusal(message), HasSubstr("must be above the kappa before it"));
  message.mutable_transfer_curve()->mutable_points(1)->set_kappa(1);
  EXPECT_EQ(refusal(message), "accepted");
  message.mutable_transfer_curve()->mutable_points(1)->set_alpha(0);
  EXPECT_THAT(refusal(message), HasSubstr("curve point 2"));
}

TEST(EditWire, AStrokeNeedsABrushAFallOffAndAPath) {
  EXPECT_EQ(refusal(stroke_message()), "accepted");
  v1::Edit message = stroke_message();
  message.mutable_stroke()->mutable_brush()->set_fall_off(v1::FALL_OFF_UNSPECIFIED);
  EXPECT_THAT(refusal(message), HasSubstr("fall-off 0"));
  message = stroke_message();
  message.mutable_stroke()->mutable_brush()->set_radius(0);
  EXPECT_THAT(refusal(message), HasSubstr("radius"));
  message = stroke_message();
  message.mutable_stroke()->clear_path();
  EXPECT_THAT(refusal(message), HasSubstr("no points"));
  message = stroke_message();
  message.mutable_stroke()->add_path()->set_y(1e300);
  EXPECT_THAT(refusal(message), HasSubstr("point 2"));
}

TEST(EditWire, CellFieldsAreCheckedOneByOne) {
  v1::Edit message = with_id();
  v1::CellField* cell = message.mutable_cell_fields()->add_cells();
  cell->set_alpha1(5);
  cell->set_alpha2(5);
  cell->set_beta(1);
  EXPECT_EQ(refusal(message), "accepted");
  *message.mutable_cell_fields()->add_cells() = *cell;
  message.mutable_cell_fields()->mutable_cells(1)->set_alpha2(-1);
  EXPECT_THAT(refusal(message), HasSubstr("cell field 2: alpha2"));
}

TEST(EditWire, PartsOfAnUploadSetOneThing) {
  const SetCellFields edges{{{Vec3i(1, 2, 3), 0, 0, 0.5}}, CellTarget::kEdges};
  SetCellFields joined;
  ASSERT_TRUE(append_cells(to_wire(edges, 0, 1), joined).is_ok());
  ASSERT_TRUE(append_cells(to_wire(edges, 0, 1), joined).is_ok());
  EXPECT_EQ(joined.target, CellTarget::kEdges);
  EXPECT_EQ(joined.cells.size(), 2u);
  const SetCellFields held{edges.cells, CellTarget::kProtection};
  EXPECT_EQ(append_cells(to_wire(held, 0, 1), joined).code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace burnish

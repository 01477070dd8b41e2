#include "common/edit/edit.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Status check(decltype(Edit::change) change) {
  return validate(Edit{"an id", std::move(change)});
}

TEST(Edit, ThatChangesNothingOutOfRangeIsValid) {
  Stroke stroke;
  stroke.brush.radius = 1;
  stroke.path = {{0, 0, 0}};
  EXPECT_TRUE(check(SetGradientScale{10}).is_ok());
  EXPECT_TRUE(check(SetTransferCurve{}).is_ok());
  EXPECT_TRUE(check(stroke).is_ok());
  EXPECT_TRUE(check(SetCellFields{{{{1, 2, 3}, 1, 1000, 0}}}).is_ok());
}

TEST(Edit, IsRefusedByItsOwnKindsLimits) {
  EXPECT_THAT(check(SetGradientScale{NAN}).message(), HasSubstr("beta nan"));
  EXPECT_THAT(check(Stroke{}).message(), HasSubstr("brush radius"));
}

TEST(CellFields, AreRefusedByTheirNumberInTheList) {
  const auto refusal = [](double alpha1, double alpha2, double beta) {
    return check(SetCellFields{{{{0, 0, 0}, 50, 50, 1}, {{1, 0, 0}, alpha1, alpha2, beta}}});
  };
  EXPECT_EQ(refusal(0, 1, 1).code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(refusal(0, 1, 1).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("alpha1")));
  EXPECT_THAT(refusal(1, NAN, 1).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("alpha2")));
  EXPECT_THAT(refusal(1, 1, 11).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("beta 11")));
  EXPECT_THAT(refusal(1, 1001, 1).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("1000")));
}

TEST(CellFields, OfPaintAndProtectionHaveTheirOwnLimits) {
  const auto refusal = [](double value, CellTarget target) {
    return check(SetCellFields{{{{0, 0, 0}, 0, 0, value}}, target});
  };
  EXPECT_TRUE(refusal(0.25, CellTarget::kEdges).is_ok());
  EXPECT_THAT(refusal(1.5, CellTarget::kEdges).message(),
              AllOf(HasSubstr("cell field 1"), HasSubstr("strength 1.5"), HasSubstr("0..1")));
  EXPECT_FALSE(refusal(NAN, CellTarget::kEdges).is_ok());
  EXPECT_TRUE(refusal(4, CellTarget::kTexture).is_ok());
  EXPECT_THAT(refusal(4.5, CellTarget::kTexture).message(),
              AllOf(HasSubstr("texture gain 4.5"), HasSubstr("0..4")));
  EXPECT_TRUE(refusal(0, CellTarget::kProtection).is_ok());
  EXPECT_TRUE(refusal(1, CellTarget::kProtection).is_ok());
  EXPECT_THAT(refusal(0.5, CellTarget::kProtection).message(), HasSubstr("protection 0.5"));
}

TEST(Edit, SaysWhatItDoesInAFewWords) {
  const auto said = [](decltype(Edit::change) change) {
    return summary({"id", std::move(change)});
  };
  EXPECT_EQ(said(SetGradientScale{0.25}), "beta 0.25");
  EXPECT_EQ(said(SetTransferCurve{TransferCurve(7)}), "alpha 7");
  EXPECT_EQ(said(SetTransferCurve{*TransferCurve::create({{-1, 5}, {1, 50}})}),
            "curve of 2 points, contrast 10");
  EXPECT_EQ(said(Stroke{{0.5, 1, 2, FallOff::kSmooth}, {{0, 0, 0}}}),
            "stroke of 1 point, radius 0.5, beta 2");
  EXPECT_EQ(said(SetCellFields{}), "fields of 0 cells");
  EXPECT_EQ(said(SetCellFields{{{{0, 0, 0}, 0, 0, 1}}, CellTarget::kEdges}),
            "edges kept in 1 cell");
  EXPECT_EQ(said(SetCellFields{{}, CellTarget::kProtection}), "protection of 0 cells");
  EXPECT_EQ(said(SetCellFields{{}, CellTarget::kTexture}), "texture gain in 0 cells");
  EXPECT_EQ(said(SwitchEntry{3, false}), "switch off 3");
  EXPECT_EQ(said(SetControls{}), "rims free");
  EXPECT_EQ(said(SetControls{{true, 0.5, true}}), "rims pinned, at most 0.5, volume kept");
}

TEST(Edit, KindsAreNamedInTheOrderOfTheChanges) {
  EXPECT_STREQ(edit_kind_name(kind_of({"id", SetGradientScale{}})), "slider");
  EXPECT_STREQ(edit_kind_name(kind_of({"id", Undo{}})), "undo");
  EXPECT_STREQ(edit_kind_name(kind_of({"id", RestoreCheckpoint{}})), "restore");
  EXPECT_STREQ(edit_kind_name(kind_of({"id", SetControls{}})), "controls");
  EXPECT_TRUE(makes_fields(EditKind::kCellFields));
  EXPECT_TRUE(makes_fields(EditKind::kControls));
  EXPECT_FALSE(makes_fields(EditKind::kUndo));
}

TEST(Edit, ACheckpointHasAShortPrintableName) {
  EXPECT_TRUE(check(SetCheckpoint{"before lunch"}).is_ok());
  EXPECT_THAT(check(SetCheckpoint{""}).message(), HasSubstr("is empty"));
  EXPECT_THAT(check(RestoreCheckpoint{std::string(201, 'x')}).message(), HasSubstr("201 bytes"));
  EXPECT_FALSE(check(SetCheckpoint{"a\nb"}).is_ok());
  EXPECT_FALSE(check(SwitchEntry{0, true}).is_ok());
}

}  // namespace
}  // namespace burnish

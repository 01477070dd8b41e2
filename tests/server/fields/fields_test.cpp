#include "server/fields/fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/fields/paint_checkpoints.h"
#include "server/prepare/prepare.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAreArray;
using testing::HasSubstr;

constexpr double kRadius = 0.5;

class FieldsTest : public testing::Test {
 protected:
  static std::shared_ptr<const PreparedMesh> prepared_sphere() {
    PrepareOptions options;
    options.depth = 5;
    return *prepare(make_icosphere(3, 1), options);
  }

  static Stroke stroke(double beta, FallOff fall_off = FallOff::kSmooth, double strength = 1) {
    return {{kRadius, strength, beta, fall_off}, {{1, 0, 0}, {0.7, 0.7, 0.1}, {0, 1, 0.2}}};
  }

  Vec3i cell(size_t c) const { return morton_point(prepared_->cells[c]); }
  Vec3d centre(size_t c) const {
    return prepared_->frame.to_file(cell(c).cast<double>() + Vec3d::Constant(0.5));
  }
  static std::vector<float> copy(std::span<const float> values) {
    return {values.begin(), values.end()};
  }

  std::shared_ptr<const PreparedMesh> prepared_ = prepared_sphere();
  Fields fields_{*prepared_};
};

TEST_F(FieldsTest, BeginAtTheDefaults) {
  EXPECT_EQ(fields_.alphas().alpha1.size(), prepared_->cells.size());
  EXPECT_THAT(fields_.alphas().alpha1, Each(50));
  EXPECT_THAT(fields_.alphas().alpha2, Each(50));
  EXPECT_THAT(fields_.view().beta, Each(1));
}

TEST_F(FieldsTest, TakeTheCurveAtEachCellsCurvatures) {
  const TransferCurve curve = *TransferCurve::create({{-5, 400}, {5, 4}});
  fields_.set_transfer_curve(curve);
  const CellAlphas alphas = fields_.alphas();
  for (size_t c = 0; c < prepared_->cells.size(); ++c) {
    const CellCurvature& of_cell = prepared_->curvature[c];
    ASSERT_EQ(alphas.alpha1[c], static_cast<float>(curve.alpha(of_cell.kappa1)));
    ASSERT_EQ(alphas.alpha2[c], static_cast<float>(curve.alpha(of_cell.kappa2)));
  }
}

TEST_F(FieldsTest, ANewStrokeThatTouchesNoCellIsRefused) {
  EXPECT_TRUE(fields_.check_new(stroke(2)).is_ok());
  const Brush brush{.radius = 0.25, .beta = 2};
  EXPECT_TRUE(fields_.check_new(Stroke{brush, {{5, 0, 0}, {1, 0, 0}}}).is_ok());
  const Brush fine{.radius = 1e-6, .beta = 2};
  EXPECT_TRUE(fields_.check_new(Stroke{fine, {prepared_->vertices[0]}}).is_ok());
  const Status refused = fields_.check_new(Stroke{brush, {{5, 0, 0}, {5, 1, 0}}});
  EXPECT_EQ(refused.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(refused.message(), HasSubstr("0.25"));
}

TEST_F(FieldsTest, SliderAndPaintAreIndependent) {
  fields_.paint(stroke(3));
  fields_.set_gradient_scale(0.25);
  fields_.set_gradient_scale(0.5);
  Fields other(*prepared_);
  other.set_gradient_scale(0.5);
  other.paint(stroke(3));
  EXPECT_THAT(copy(fields_.view().beta), ElementsAreArray(other.view().beta));
  EXPECT_THAT(fields_.view().beta, testing::Contains(0.5f));
  EXPECT_THAT(fields_.view().beta, testing::Contains(testing::Gt(2.5f)));
}

TEST_F(FieldsTest, FullPaintHidesTheSliderAndNoPaintLeavesIt) {
  fields_.paint(stroke(3, FallOff::kConstant));
  fields_.set_gradient_scale(0.5);
  int painted = 0;
  for (size_t c = 0; c < prepared_->cells.size(); ++c) {
    double distance = 1e30;
    for (const Vec3d& dab : dab_centres(stroke(3)))
      distance = std::min(distance, (centre(c) - dab).norm());
    ASSERT_EQ(fields_.view().beta[c], distance < kRadius ? 3 : 0.5f);
    painted += distance < kRadius;
  }
  EXPECT_GT(painted, 100);
}

TEST_F(FieldsTest, OneDabBlendsByStrengthTimesFallOff) {
  Stroke dab = stroke(4, FallOff::kLinear, 0.5);
  dab.path.resize(1);
  fields_.paint(dab);
  for (size_t c = 0; c < prepared_->cells.size(); ++c) {
    const double weight = 0.5 * std::max(0.0, 1 - (centre(c) - dab.path[0]).norm() / kRadius);
    ASSERT_NEAR(fields_.view().beta[c], 1 + 3 * weight, 1e-6);
  }
}

TEST_F(FieldsTest, ADabReachesEveryCellOfItsBallAndNoOther) {
  for (const Vec3d& at : {Vec3d(1, 0, 0), Vec3d(0, -1, 0), Vec3d(0.6, 0, 0.8), Vec3d(9, 9, 9)})
    for (const double radius : {0.05, 0.3, 3.0}) {
      Fields fields(*prepared_);
      fields.paint({radius, 1, 2, FallOff::kConstant}, std::vector<Vec3d>{at});
      for (size_t c = 0; c < prepared_->cells.size(); ++c)
        ASSERT_EQ(fields.view().beta[c], (centre(c) - at).norm() < radius ? 2 : 1)
            << "cell " << c << ", radius " << radius;
    }
}

TEST_F(FieldsTest, ALaterStrokeCoversAnEarlierOne) {
  fields_.paint(stroke(4));
  fields_.paint(stroke(0, FallOff::kConstant));
  Fields only_last(*prepared_);
  only_last.paint(stroke(0, FallOff::kConstant));
  for (size_t c = 0; c < prepared_->cells.size(); ++c) {
    const float last = only_last.view().beta[c];
    ASSERT_EQ(last == 0, fields_.view().beta[c] == 0);
  }
}

TEST_F(FieldsTest, PaintThatWasKeptComesBack) {
  fields_.paint(stroke(3));
  const PaintedCells kept = fields_.painted();
  const std::vector<float> beta = copy(fields_.view().beta);
  const auto painted = std::ranges::count_if(beta, [](float b) { return b != 1; });
  EXPECT_GT(painted, 0);
  EXPECT_GE(std::ssize(kept.cells), painted);
  fields_.set_painted({});
  EXPECT_THAT(fields_.view().beta, Each(1));
  EXPECT_EQ(fields_.painted(), PaintedCells{});
  fields_.set_painted(kept);
  EXPECT_THAT(fields_.view().beta, ElementsAreArray(beta));
  EXPECT_EQ(fields_.painted(), kept);
}

TEST_F(FieldsTest, PaintOfEveryKindComesBackFromBytes) {
  Stroke gain = stroke(3), curve = stroke(0.5);
  gain.brush.band = 2;
  curve.brush.curve = 8;
  for (const Stroke& one : {stroke(0.25), gain, curve}) fields_.paint(one);
  const PaintedCells kept = fields_.painted();
  EXPECT_THAT(kept.layer, AllOf(Contains(kBetaLayer), Contains(kFirstBandLayer + 1),
                                Contains(kFirstCurveLayer + 7)));
  const std::string bytes = painted_to_bytes(kept);
  EXPECT_EQ(painted_from_bytes(bytes, prepared_->cells.size()).value(), kept);
  Fields other(*prepared_);
  other.set_painted(kept);
  EXPECT_EQ(other.painted(), kept);
  EXPECT_TRUE(other.has_painted_curves());
}

TEST_F(FieldsTest, PaintOfAnotherKindLeavesBetaAlone) {
  Stroke gain = stroke(3);
  gain.brush.band = 1;
  fields_.paint(gain);
  EXPECT_THAT(fields_.view().beta, Each(1));
}

TEST_F(FieldsTest, PaintDoesNotDependOnHowTheStrokeWasSampled) {
  const Stroke coarse = stroke(3, FallOff::kSmooth, 0.3);
  Stroke fine = coarse;
  fine.path = {coarse.path.front()};
  for (size_t i = 1; i < coarse.path.size(); ++i)
    for (int part = 1; part <= 50; ++part)
      fine.path.push_back(coarse.path[i - 1] +
                          (coarse.path[i] - coarse.path[i - 1]) * (part / 50.0));
  fields_.paint(coarse);
  Fields other(*prepared_);
  other.paint(fine);
  for (size_t c = 0; c < prepared_->cells.size(); ++c)
    ASSERT_NEAR(fields_.view().beta[c], other.view().beta[c], 1e-6);
}

TEST_F(FieldsTest, OverridesHoldAgainstSliderPaintAndCurve) {
  ASSERT_TRUE(fields_.override_cells({{{cell(7), 3, 30, 0.1}, {cell(9), 5, 5, 2}}}).is_ok());
  ASSERT_TRUE(fields_.override_cells({{{cell(9), 6, 6, 7}}}).is_ok());
  fields_.set_gradient_scale(0.5);
  fields_.paint(stroke(3));
  fields_.set_transfer_curve(TransferCurve(80));
  const FieldsView view = fields_.view();
  const CellAlphas alphas = fields_.alphas();
  EXPECT_EQ(alphas.alpha1[7], 3);
  EXPECT_EQ(alphas.alpha2[7], 30);
  EXPECT_EQ(view.beta[7], 0.1f);
  EXPECT_EQ(alphas.alpha1[9], 6);
  EXPECT_EQ(view.beta[9], 7);
  EXPECT_EQ(alphas.alpha1[8], 80);
}

// Checks that β is the slider's part plus paint's own. Stretches that claim no paint must have
// none.
void expect_parts_make_beta(const FieldsView& view) {
  for (size_t c = 0; c < view.beta.size(); ++c) {
    const float follow = view.paint.follow[c], own = view.paint.own[c];
    ASSERT_NEAR(view.beta[c], 1 + follow * (view.gradient_scale - 1) + own, 1e-6) << "cell " << c;
    if (!view.paint.is_painted[c / CellPaint::kStretch]) {
      ASSERT_EQ(follow, 1) << "cell " << c;
      ASSERT_EQ(own, 0) << "cell " << c;
    }
  }
}

TEST_F(FieldsTest, WhatBetaComesFromMakesBetaAfterEveryEdit) {
  const auto paint_of = [&] {
    const CellPaint paint = fields_.view().paint;
    return std::pair(copy(paint.follow), copy(paint.own));
  };
  const auto untouched = paint_of();
  fields_.set_gradient_scale(0.5);
  expect_parts_make_beta(fields_.view());
  EXPECT_EQ(paint_of(), untouched);
  fields_.paint(stroke(3));
  expect_parts_make_beta(fields_.view());
  const auto painted = paint_of();
  EXPECT_NE(painted, untouched);
  fields_.set_gradient_scale(2);
  expect_parts_make_beta(fields_.view());
  EXPECT_EQ(paint_of(), painted);  // a slider leaves paint alone
  ASSERT_TRUE(fields_.override_cells({{{cell(7), 3, 30, 0.1}}}).is_ok());
  expect_parts_make_beta(fields_.view());
  EXPECT_EQ(fields_.view().paint.follow[7], 0);
  fields_.set_painted({});
  expect_parts_make_beta(fields_.view());
  EXPECT_EQ(fields_.view().paint.follow[7], 0);
  fields_.clear_overrides();
  expect_parts_make_beta(fields_.view());
  EXPECT_EQ(paint_of(), untouched);
}

TEST_F(FieldsTest, AnInactiveCellIsRefusedByNameAndNothingChanges) {
  fields_.set_gradient_scale(0.5);
  for (const Vec3i& bad : {Vec3i(16, 15, 16), Vec3i(0, 0, 32), Vec3i(-1, 0, 0)}) {
    const Status status = fields_.override_cells({{{cell(0), 3, 3, 3}, {bad, 4, 4, 4}}});
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(status.message(),
                HasSubstr("cell " + std::to_string(bad.x()) + " " + std::to_string(bad.y()) + " " +
                          std::to_string(bad.z())));
    EXPECT_THAT(fields_.alphas().alpha1, Each(50));
    EXPECT_THAT(fields_.view().beta, Each(0.5f));
  }
  fields_.set_gradient_scale(1);  // must not bring a refused override back
  EXPECT_THAT(fields_.view().beta, Each(1));
}

}  // namespace
}  // namespace burnish

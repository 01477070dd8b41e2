#include "server/fields/changing_alphas.h"

#include <gtest/gtest.h>

#include "server/fields/fields.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

class ChangingAlphasTest : public testing::Test {
 protected:
  ChangingAlphasTest() : system_(reference::bumpy_sphere(4), 6), alphas_(*system_.prepared) {
    take();
  }
  std::vector<int32_t> take() {
    const std::vector<int32_t> changed = alphas_.take(system_.fields.view().metric);
    EXPECT_EQ(alphas_.latest(), system_.fields.alphas());
    return changed;
  }
  void dab(int32_t curve) {
    const Brush brush = {.radius = 0.2, .strength = 0.5, .curve = curve};
    system_.fields.paint({brush, {system_.prepared->vertices[5]}});
  }
  size_t cells() const { return system_.prepared->cells.size(); }

  TestSystem system_;
  ChangingAlphas alphas_;
};

TEST_F(ChangingAlphasTest, ADabOfACurveChangesItsCellsAlone) {
  system_.fields.set_palette({{{"painted", 0, TransferCurve(20)}}});
  dab(1);
  const std::vector<int32_t> first = take();
  EXPECT_FALSE(first.empty());
  EXPECT_LT(first.size(), cells() / 10);
  EXPECT_TRUE(take().empty());
  dab(1);
  EXPECT_EQ(take(), first);
}

TEST_F(ChangingAlphasTest, CellsThatLoseTheirOwnAlphaChange) {
  system_.fields.set_palette({{{"painted", 0, TransferCurve(20)}}});
  dab(1);
  const std::vector<int32_t> painted = take();
  system_.fields.set_painted({});
  EXPECT_EQ(take(), painted);
}

TEST_F(ChangingAlphasTest, ACurveChangesTheCellsOfOtherCurvature) {
  EXPECT_TRUE(take().empty());
  system_.fields.set_transfer_curve(TransferCurve(20));
  EXPECT_EQ(take().size(), cells());
  float least = 1e9f;
  for (const CellCurvature& of : system_.prepared->curvature) least = std::min(least, of.kappa2);
  const double from = least / 2;  // few cells are so concave
  system_.fields.set_transfer_curve(TransferCurve::create({{2 * from, 5}, {from, 20}}).value());
  const size_t changed = take().size();
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, cells() / 2);
}

}  // namespace
}  // namespace burnish

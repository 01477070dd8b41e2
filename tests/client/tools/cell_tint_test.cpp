#include "client/tools/cell_tint.h"

#include <gtest/gtest.h>

#include "tests/client/scene/gridded_sphere.h"

namespace burnish {
namespace {

TEST(CellTint, ADabTintsTheCellsInItsBallByTheServersFallOff) {
  const View view = make_sphere_view(6);
  CellTint tint(view);
  const Vec3d centre = Vec3d(3, -2, 1) + Vec3d(0, 0, 1);
  const Brush brush{.radius = 0.4, .strength = 0.5, .beta = 0};
  const IndexRange changed = tint.add_dab(brush, centre);
  size_t tinted = 0;
  for (size_t c = 0; c < view.grid.cells.size(); ++c) {
    const Vec3d at = view.frame.to_file(morton_point(view.grid.cells[c].place).cast<double>() +
                                        Vec3d::Constant(0.5));
    const double expected = 0.5 * fall_off_weight(brush.fall_off, (at - centre).norm() / 0.4);
    ASSERT_NEAR(tint.weights()[c], expected, 1e-4);
    if (tint.weights()[c] == 0) continue;
    ++tinted;
    EXPECT_GE(c, changed.first);
    EXPECT_LT(c, changed.first + changed.count);
  }
  EXPECT_GT(tinted, 50u);
}

TEST(CellTint, DabsAddUpToOneAndAreGoneAfterClear) {
  const View view = make_sphere_view();
  CellTint tint(view);
  const Vec3d centre = Vec3d(3, -2, 2);
  for (int i = 0; i < 50; ++i) tint.add_dab({.radius = 0.5, .strength = 0.3, .beta = 2}, centre);
  const float strongest = *std::max_element(tint.weights().begin(), tint.weights().end());
  EXPECT_GT(strongest, 0.9f);
  EXPECT_LE(strongest, 1.0f);
  EXPECT_GT(tint.clear().count, 0u);
  EXPECT_TRUE(tint.is_clear());
  EXPECT_EQ(*std::max_element(tint.weights().begin(), tint.weights().end()), 0.0f);
}

}  // namespace
}  // namespace burnish

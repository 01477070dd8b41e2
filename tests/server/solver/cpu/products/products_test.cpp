#include "server/solver/cpu/products/products.h"

#include <limits>

#include <gtest/gtest.h>

#include "server/solver/cpu/assembly/assembly.h"
#include "server/solver/cpu/products/exact_product.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

Float4 wave(int32_t i) {
  const auto at = static_cast<float>(i % 97);
  return {at, 1 - at, at * at, 0};
}

// Products of the finest depth, with tiles of at most this width.
struct Products {
  Products(const TestSystem& system, int32_t width_max) {
    Hierarchy hierarchy = *system.hierarchy;
    Stencil& stencil = hierarchy.depths.back().stencil;
    stencil.tiles = make_row_tiles(stencil, width_max);
    wide = std::ranges::count(stencil.tiles.is_wide, 1);
    tiles = stencil.tiles.count();
    std::vector<CpuDepth> depths;
    depths.reserve(hierarchy.depths.size());
    for (const HierarchyDepth& topology : hierarchy.depths) depths.emplace_back(topology);
    ExactMatrix exact(stencil);
    assemble(*system.prepared, system.fields.alphas(), depths, &exact);

    CpuDepth& finest = depths.back();
    std::vector<Double3> p(finest.corner_count());
    for (int32_t i = 0; i < finest.corner_count(); ++i) {
      finest.x[i] = wave(i);
      finest.f[i] = wave(i + 31);
      p[i] = wave(i).head<3>().cast<double>();
    }
    compute_residual(finest);
    residual = finest.r;
    of_floats.resize(p.size());
    of_doubles.resize(p.size());
    exact_product(finest, exact, finest.x, of_floats, 0, finest.corner_count());
    exact_product(finest, exact, p, of_doubles, 0, finest.corner_count());
    expected.resize(p.size());
    for (int32_t i = 0; i < finest.corner_count(); ++i)
      expected[i] = finest.inverse_diagonal[i] == 0
                        ? Float4(Float4::Zero())
                        : Float4(finest.f[i] - product_row(stencil, finest.system, finest.x, i));
  }

  int64_t wide, tiles;
  std::vector<Float4> residual, expected;
  std::vector<Double3> of_floats, of_doubles;
};

template <typename Vector>
double distance(const Vector& a, const Vector& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i)
    most = std::max(most, static_cast<double>((a[i] - b[i]).abs().maxCoeff()));
  return most;
}

std::vector<Float4> scaled(std::vector<Float4> v, float factor) {
  for (Float4& at : v) at *= factor;
  return v;
}

class RowProducts : public testing::Test {
 protected:
  TestSystem system_{reference::bumpy_sphere(5), 6};
};

TEST_F(RowProducts, AreThoseOfRowsOneByOne) {
  const Products products(system_, RowTiles::kWidthMax);
  EXPECT_EQ(products.wide, 0);
  EXPECT_GT(products.tiles, 4);
  double largest = 0;
  for (const Float4& at : products.expected)
    largest = std::max(largest, static_cast<double>(at.abs().maxCoeff()));
  EXPECT_LT(distance(products.residual, products.expected), 1e-5 * largest);
  EXPECT_EQ(distance(products.of_floats, products.of_doubles), 0);
}

TEST_F(RowProducts, AreTheSameBitsWhereTilesAreTooWide) {
  const Products narrow(system_, RowTiles::kWidthMax);
  for (const int32_t width_max : {0, 700}) {
    const Products products(system_, width_max);
    EXPECT_GT(products.wide, 0) << width_max;
    EXPECT_EQ(products.wide == products.tiles, width_max == 0);
    EXPECT_EQ(distance(products.residual, narrow.residual), 0);
    EXPECT_EQ(distance(products.of_floats, narrow.of_floats), 0);
    EXPECT_EQ(distance(products.of_doubles, narrow.of_doubles), 0);
  }
}

TEST_F(RowProducts, TilesHaveEachRowAndColumnWhereTheySay) {
  for (const HierarchyDepth& depth : system_.hierarchy->depths) {
    const Stencil& stencil = depth.stencil;
    const RowTiles& tiles = stencil.tiles;
    const int32_t n = depth.grid.corner_count();
    for (int32_t row = 0; row < n; ++row) {
      const int32_t tile = row / RowTiles::kRows, first = tile * RowTiles::kRows;
      const int32_t rows = std::min(n - first, RowTiles::kRows);
      ASSERT_EQ(first + tiles.row[row].place, stencil.corner_of_row[row]);
      ASSERT_EQ(stencil.row_start[row] + Stencil::kRowPadding * tiles.row[row].groups,
                stencil.row_start[row + 1]);
      for (int64_t k = stencil.row_start[row]; k < stencil.row_start[row + 1]; ++k) {
        ASSERT_EQ(tiles.twice_local[k] % 2, 0);
        const int32_t local = tiles.twice_local[k] / 2;
        ASSERT_LT(local, tiles.width_max);
        ASSERT_EQ(stencil.column[k], local < rows ? first + local : tiles.halo[tile][local - rows]);
      }
    }
  }
}

TEST_F(RowProducts, KeepAsMuchAsTheyAreTold) {
  std::vector<CpuDepth> depths;
  for (const HierarchyDepth& topology : system_.hierarchy->depths) depths.emplace_back(topology);
  assemble(*system_.prepared, system_.fields.alphas(), depths, nullptr);
  CpuDepth& finest = depths.back();
  for (int32_t i = 0; i < finest.corner_count(); ++i) finest.x[i] = finest.f[i] = wave(i);
  compute_residual(finest);
  const std::vector<Float4> residual = finest.r;
  compute_residual(finest, 0.5F, 0.25F);
  EXPECT_EQ(distance(finest.r, scaled(residual, 0.75F)), 0);

  finest.r.assign(finest.r.size(), Float4::Constant(std::numeric_limits<float>::quiet_NaN()));
  compute_residual(finest);
  EXPECT_EQ(distance(finest.r, residual), 0);
}

}  // namespace
}  // namespace burnish::cpu

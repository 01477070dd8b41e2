#include "common/mesh/textures/texture_sweep.h"

#include <cmath>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr PictureSize kTallSize = {3, 4096, 0};

/// A triangle over 3,000 rows of a tall picture.
SurfaceTextures tall_triangle() {
  SurfaceTextures textures;
  textures.materials = {{.picture = 0}};
  textures.coordinates = {{0.1F, 0.1F}, {0.9F, 0.5F}, {0.3F, 0.8F}};
  textures.triangles = {{.material = 0, .corners = {0, 1, 2}}};
  return textures;
}

/// Sums what each corner gets of a picture whose rows grow slowly brighter. Counts the parts.
std::array<Eigen::Array4d, 3> swept(double row_visits_max, size_t& parts) {
  const SurfaceTextures textures = tall_triangle();
  const std::array<uint32_t, 1> triangles = {0};
  TextureSweep sweep(
      textures, triangles, kTallSize, [] { return true; }, row_visits_max);
  std::array<Eigen::Array4d, 3> sums;
  sums.fill(Eigen::Array4d::Zero());
  for (uint32_t y = 0; y < kTallSize.height; ++y) {
    const auto level = static_cast<uint8_t>(y / 16);
    const std::vector<Rgba8> row(kTallSize.width, Rgba8{level, 255, 0, 255});
    sweep.take({y, 0, 1, row}, [&](uint32_t, int corner, const Eigen::Array4d& part) {
      sums[static_cast<size_t>(corner)] += part;
      ++parts;
    });
  }
  return sums;
}

TEST(TextureSweep, FewerRowsThanThereAreGiveNearlyTheSameMeans) {
  size_t all = 0, some = 0;
  const auto exact = swept(TextureSweep::kRowVisitsMax, all), rough = swept(100, some);
  EXPECT_LT(20 * some, all);
  for (size_t corner = 0; corner < 3; ++corner) {
    EXPECT_NEAR(exact[corner][3], 1.0 / 3, 1e-3);
    EXPECT_NEAR(rough[corner][3], 1.0 / 3, 0.02);
    EXPECT_NEAR(rough[corner][0] / rough[corner][3], exact[corner][0] / exact[corner][3], 0.01);
    EXPECT_NEAR(rough[corner][1] / rough[corner][3], 1, 1e-6);
  }
}

TEST(TextureSweep, ACancelIsHeardWithinARow) {
  SurfaceTextures textures = tall_triangle();
  textures.triangles.resize(5000, textures.triangles[0]);
  std::vector<uint32_t> triangles(textures.triangles.size());
  for (uint32_t t = 0; t < triangles.size(); ++t) triangles[t] = t;
  bool goes_on = true;
  constexpr double kEveryRow = 1e9;
  TextureSweep sweep(
      textures, triangles, kTallSize, [&] { return goes_on; }, kEveryRow);
  const std::vector<Rgba8> row(kTallSize.width, Rgba8{});
  size_t parts = 0;
  const auto count = [&](uint32_t, int, const Eigen::Array4d&) { ++parts; };
  sweep.take({1000, 0, 1, row}, count);
  EXPECT_FALSE(sweep.is_cancelled());
  EXPECT_EQ(parts, 5000U);
  goes_on = false;
  parts = 0;
  sweep.take({1001, 0, 1, row}, count);
  EXPECT_TRUE(sweep.is_cancelled());
  EXPECT_LE(parts, 4096U);
  sweep.take({1002, 0, 1, row}, count);
  EXPECT_LE(parts, 4096U);
}

}  // namespace
}  // namespace burnish

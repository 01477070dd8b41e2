#include "common/mesh/rewrite/pictures/texel_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/mesh/textures/shown_picture.h"
#include "tests/common/mesh/rewrite/textured_grid.h"

namespace burnish {
namespace {

constexpr uint32_t kWidth = 120, kHeight = 90;

/// A grid on a picture, whose vertices have one colour before and others after.
struct PaintedGrid {
  explicit PaintedGrid(const TexturedGrid& grid) {
    SurfaceMaterial material;
    material.picture = 0;
    surface.textures.materials = {material};
    surface.textures.pictures.resize(1);
    grid.each_vertex([&](int x, int y) {
      const auto [u, v] = grid.coordinate(x, y);
      surface.mesh.vertices.emplace_back(x, y, 0);
      surface.textures.coordinates.push_back({static_cast<float>(u), static_cast<float>(v)});
    });
    grid.each_face([&](int a, int b, int c) {
      const Triangle corners = {static_cast<uint32_t>(a), static_cast<uint32_t>(b),
                                static_cast<uint32_t>(c)};
      surface.mesh.triangles.push_back(corners);
      surface.textures.triangles.push_back({0, {corners[0], corners[1], corners[2]}});
    });
    before.assign(surface.mesh.vertices.size(), Rgba8{120, 120, 120, 255});
    after = before;
  }

  /// Returns a grey picture's texels after the change, in bands of so many rows.
  std::vector<FileTexel> changed(uint32_t band_rows = 64, uint16_t max = 255) {
    std::vector<uint32_t> triangles(surface.mesh.triangles.size());
    for (uint32_t t = 0; t < triangles.size(); ++t) triangles[t] = t;
    const auto place = PicturePlace::find(surface.textures, triangles, kWidth, kHeight);
    EXPECT_TRUE(place.is_ok()) << place.status().message();
    TexelChanges changes({surface, {before, after, texels_at_vertices}}, triangles, *place, kWidth,
                         kHeight);
    const auto grey = static_cast<uint16_t>(100 * (max / 255));
    std::vector<FileTexel> texels(kWidth * kHeight, FileTexel{grey, grey, grey});
    for (uint32_t first = 0; first < kHeight; first += band_rows) {
      const uint32_t rows = std::min(band_rows, kHeight - first);
      const auto band = std::span(texels).subspan(size_t{first} * kWidth, size_t{rows} * kWidth);
      EXPECT_TRUE(changes.change({first, rows, kWidth, max, band}, {}).is_ok());
    }
    shared_texels = changes.shared_texels();
    return texels;
  }

  TexturedSurface surface;
  std::vector<Rgba8> before, after;
  std::vector<TexelChange> texels_at_vertices;
  uint64_t shared_texels = 0;
};

PaintedGrid bright_grid(const TexturedGrid& grid = {}) {
  PaintedGrid painted(grid);
  for (size_t v = 0; v < painted.after.size(); ++v)
    painted.after[v] = {static_cast<uint8_t>(130 + v), 90, 120, 255};
  return painted;
}

TEST(TexelChanges, TexelsInTrianglesAreThoseThatRenderersShow) {
  PaintedGrid grid = bright_grid();
  const auto texels = grid.changed();
  int covered = 0;
  for (uint32_t t = 0; t < grid.surface.mesh.triangles.size(); ++t) {
    auto corners = corners_on_picture(grid.surface.textures, t);
    for (Eigen::Vector2d& corner : corners)
      corner = corner.cwiseProduct(Eigen::Vector2d(kWidth, kHeight));
    for (uint32_t y = 0; y < kHeight; ++y)
      for (uint32_t x = 0; x < kWidth; ++x) {
        const auto weights = weights_at(corners, {x + 0.5, y + 0.5});
        if (!weights || weights->minCoeff() < 1e-9) continue;
        ++covered;
        for (size_t i = 0; i < 3; ++i) {
          double change = -light_of_level(120);
          for (int k = 0; k < 3; ++k)
            change +=
                (*weights)[k] * light_of_level(grid.after[grid.surface.mesh.triangles[t][k]][i]);
          EXPECT_NEAR(texels[y * kWidth + x][i], shown_channel(100, change), 0.51);
        }
      }
  }
  EXPECT_GT(covered, 3000);
  EXPECT_EQ(grid.shared_texels, 0u) << "neighbours share sides, and no texel";
}

TEST(TexelChanges, AGainMultipliesATexelBeforeTheChangeIsAdded) {
  PaintedGrid grid{TexturedGrid{}};
  grid.texels_at_vertices.assign(grid.before.size(), {2, Vec3f(-0.05F, 0, 0.1F)});
  for (const uint16_t max : {255, 65535}) {
    const FileTexel middle = grid.changed(64, max)[45 * kWidth + 60];
    for (size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(middle[i] / (max / 255.0),
                  shown_channel(100, grid.texels_at_vertices[0].light[static_cast<int>(i)], 2),
                  0.51);
  }
}

TEST(TexelChanges, BandsAndThreadsChangeNoTexel) {
  PaintedGrid grid = bright_grid();
  const auto texels = grid.changed();
  for (const uint32_t rows : {1, 7, 90}) EXPECT_EQ(grid.changed(rows), texels) << rows;
  const int threads = thread_count();
  use_threads(3);
  EXPECT_EQ(grid.changed(), texels);
  use_threads(1);
  EXPECT_EQ(grid.changed(), texels);
  use_threads(threads);
}

TEST(TexelChanges, TheChangeGoesOnBeyondTheTrianglesForSomeTexels) {
  PaintedGrid grid({.cells = 1, .begin = 0.4, .end = 0.6});
  grid.after.assign(4, Rgba8{160, 120, 120, 255});
  const auto texels = grid.changed();
  int inside = 0, row = 45;
  for (uint32_t x = 0; x < kWidth; ++x) inside += texels[row * kWidth + x][0] > 100 ? 1 : 0;
  const auto [first, last] = [&] {
    uint32_t from = kWidth, to = 0;
    for (uint32_t t = 0; t < texels.size(); ++t)
      if (texels[t][0] != 100) {
        from = std::min(from, t % kWidth);
        to = std::max(to, t % kWidth);
      }
    return std::pair(from, to);
  }();
  EXPECT_GT(inside, 10);
  EXPECT_EQ(first, 48 - kGutterTexels);  // 0.4 of 120
  EXPECT_EQ(last, 71 + kGutterTexels);
  for (const FileTexel& texel : texels)
    EXPECT_THAT(texel[0], testing::AnyOf(100, texels[45 * kWidth + 60][0]));
}

TEST(TexelChanges, TheBytesOfOnePictureDoNotDependOnUneditedTriangles) {
  PaintedGrid grid = bright_grid();
  grid.after = grid.before;
  EXPECT_THAT(grid.changed(), testing::Each(FileTexel{100, 100, 100}));
}

TEST(TexelChanges, TexelsOfTwoSurfacesGetTheMeanAndAreCounted) {
  PaintedGrid grid({.cells = 1});
  const auto twin = static_cast<uint32_t>(grid.before.size());
  grid.surface.mesh.vertices.resize(2 * twin, Vec3d(0, 0, 1));
  for (size_t t = 0; t < 2; ++t) {
    Triangle triangle = grid.surface.mesh.triangles[t];
    for (uint32_t& v : triangle) v += twin;
    grid.surface.mesh.triangles.push_back(triangle);
    grid.surface.textures.triangles.push_back(grid.surface.textures.triangles[t]);
  }
  grid.before.assign(2 * twin, Rgba8{120, 120, 120, 255});
  grid.after = grid.before;
  std::fill_n(grid.after.begin(), twin, Rgba8{160, 160, 160, 255});
  const auto texels = grid.changed();
  const double light = (std::pow(160 / 255.0, 2.2) - std::pow(120 / 255.0, 2.2)) / 2;
  const double mean = 255 * std::pow(std::pow(100 / 255.0, 2.2) + light, 1 / 2.2);
  EXPECT_NEAR(texels[45 * kWidth + 60][0], mean, 0.51);
  EXPECT_GT(grid.shared_texels, 2000u);
}

TEST(TexelChanges, SixteenBitsChangeBetweenBytes) {
  PaintedGrid grid = bright_grid();
  const auto fine = grid.changed(64, 65535);
  const auto coarse = grid.changed();
  int between = 0;
  for (size_t t = 0; t < fine.size(); ++t) {
    EXPECT_NEAR(fine[t][0] / 257.0, coarse[t][0], 0.51);
    between += fine[t][0] % 257 != 0 ? 1 : 0;
  }
  EXPECT_GT(between, 3000);
}

TEST(TexelChanges, ATintedTextureChangesByMore) {
  PaintedGrid grid({.cells = 1});
  grid.after.assign(4, Rgba8{140, 140, 140, 255});
  const auto plain = grid.changed();
  grid.surface.textures.materials[0].factor = {0.5F, 1, 0};
  const auto tinted = grid.changed();
  const size_t t = 45 * kWidth + 60;
  EXPECT_GT(tinted[t][0], plain[t][0] + 10);
  EXPECT_EQ(tinted[t][1], plain[t][1]);
  EXPECT_EQ(tinted[t][2], 100) << "no texel shows through black";
}

TEST(TexelChanges, ACancelIsHeard) {
  PaintedGrid grid = bright_grid();
  const std::vector<uint32_t> triangles = {0, 1};
  const auto place = PicturePlace::find(grid.surface.textures, triangles, 8, 8);
  TexelChanges changes({grid.surface, {grid.before, grid.after}}, triangles, *place, 8, 8);
  std::vector<FileTexel> texels(64);
  const auto stops = [] { return false; };
  EXPECT_EQ(changes.change({0, 8, 8, 255, texels}, stops).code(), StatusCode::kCancelled);
}

/// Returns where the grid's first corner lies, or why it repeats.
std::string place_of(double shift, TextureWrap wrap, double end = 0.88) {
  PaintedGrid grid({.cells = 1, .end = end, .shift = shift});
  grid.surface.textures.materials[0].wraps = {wrap, wrap};
  const std::vector<uint32_t> triangles = {0, 1};
  const auto place = PicturePlace::find(grid.surface.textures, triangles, 100, 100);
  if (!place.is_ok()) return place.status().message();
  const auto corner = place->corners(0)[0];
  return std::to_string(std::lround(corner.x())) + " " + std::to_string(std::lround(corner.y()));
}

TEST(PicturePlace, AWholeRepetitionIsThePictureItself) {
  EXPECT_EQ(place_of(0, TextureWrap::kRepeat), "13 13");
  EXPECT_EQ(place_of(1, TextureWrap::kRepeat), "13 13");
  EXPECT_EQ(place_of(-2, TextureWrap::kMirror), "13 13");
  EXPECT_EQ(place_of(1, TextureWrap::kMirror), "87 87");
}

TEST(PicturePlace, CoordinatesBeyondOneRepetitionAreRefusedWithTheirRange) {
  EXPECT_THAT(place_of(0.5, TextureWrap::kRepeat), testing::HasSubstr("1.38"));
  EXPECT_THAT(place_of(0, TextureWrap::kMirror, 3), testing::HasSubstr("repeats"));
  EXPECT_EQ(place_of(0, TextureWrap::kRepeat, 1.01), "13 13") << "a texel more is no repetition";
  EXPECT_EQ(place_of(0.5, TextureWrap::kClamp), "63 63");
}

}  // namespace
}  // namespace burnish

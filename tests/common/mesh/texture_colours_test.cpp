#include "common/mesh/textures/texture_colours.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "tests/common/mesh/texture_reference.h"
#include "tests/common/picture/encoding.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr int kLevels = 1;  // of 1.5 that a colour may be off, as bytes are whole

/// Pixels without any order.
Picture noisy_picture(uint32_t width, uint32_t height) {
  return drawn(width, height, [](uint32_t x, uint32_t y) {
    const uint32_t hash = (x * 73856093U ^ y * 19349663U) * 2654435761U;
    return Rgba8{static_cast<uint8_t>(hash >> 24), static_cast<uint8_t>(hash >> 16),
                 static_cast<uint8_t>(20 * x), 255};
  });
}

/// A strip of two triangles of different size.
TriangleMesh kite() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {1.5, 1, 0.5}, {0, 3, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Coordinates of the kite, in a frame that is turned.
std::vector<ReferenceCorners> kite_corners(double size, const Eigen::Vector2d& from) {
  const Eigen::Vector2d a = from, b = from + size * Eigen::Vector2d(0.9, 0.2),
                        c = from + size * Eigen::Vector2d(0.6, 0.8),
                        d = from + size * Eigen::Vector2d(-0.3, 1.1);
  return {{a, b, c}, {a, c, d}};
}

SurfacePicture picture_of(std::string name, const std::string& file) {
  return {std::move(name), [file]() -> Result<std::vector<uint8_t>> {
            return std::vector<uint8_t>(file.begin(), file.end());
          }};
}

SurfaceTextures textures_of(const std::vector<ReferenceCorners>& corners, const std::string& file,
                            const TextureWraps& wraps) {
  SurfaceTextures textures;
  textures.materials = {{.picture = 0, .wraps = wraps}};
  textures.pictures = {picture_of("skin", file)};
  for (const ReferenceCorners& triangle : corners) {
    TexturedTriangle& added = textures.triangles.emplace_back();
    added.material = 0;
    for (size_t k = 0; k < 3; ++k) {
      added.corners[k] = static_cast<uint32_t>(textures.coordinates.size());
      textures.coordinates.push_back(
          {static_cast<float>(triangle[k].x()), static_cast<float>(triangle[k].y())});
    }
  }
  return textures;
}

/// One colour for all counts as none, so that a white mesh takes the colours.
std::vector<Rgba8> means_of(TriangleMesh mesh, const SurfaceTextures& textures) {
  if (!mesh.has_colours()) mesh.colours.assign(mesh.vertices.size(), {255, 255, 255, 255});
  const Status status = add_texture_colours(mesh, textures, {}, "scan");
  EXPECT_TRUE(status.is_ok()) << status.message();
  return mesh.colours;
}

constexpr TextureWrap kWraps[] = {TextureWrap::kRepeat, TextureWrap::kMirror, TextureWrap::kClamp};

TEST(TextureColours, AVertexHasTheMeanOfWhatItOwnsWithAnyWrap) {
  const Picture picture = noisy_picture(23, 17);
  const std::string file = png_of(picture);
  for (const TextureWrap u : kWraps)
    for (const TextureWrap v : kWraps)
      for (const double size : {0.01, 0.05, 0.3, 1.0, 3.7}) {
        const auto corners = kite_corners(size, {0.37, -0.61});
        EXPECT_LE(largest_difference(means_of(kite(), textures_of(corners, file, {u, v})),
                                     reference_colours(kite(), corners, picture, {u, v})),
                  kLevels)
            << static_cast<int>(u) << static_cast<int>(v) << " " << size;
      }
}

TEST(TextureColours, ATriangleMayLieAnywhereOnTheEndlessTexture) {
  const Picture picture = noisy_picture(9, 12);
  for (const TextureWrap wrap : kWraps)
    for (const double x : {-7.3, -0.5, 0.0, 0.96, 5.2})
      for (const double y : {-4.1, 0.02, 0.97, 11.5}) {
        const auto corners = kite_corners(0.8, {x, y});
        const SurfaceTextures textures = textures_of(corners, png_of(picture), {wrap, wrap});
        EXPECT_LE(largest_difference(means_of(kite(), textures),
                                     reference_colours(kite(), corners, picture, {wrap, wrap})),
                  kLevels)
            << static_cast<int>(wrap) << " " << x << " " << y;
      }
}

TEST(TextureColours, TrianglesThatAreLinesOrPointsOnTheTextureHaveItsColours) {
  const Picture picture = noisy_picture(8, 8);
  const Eigen::Vector2d a(0.2, 0.3);
  for (const auto& [along, further] :
       {std::pair(Eigen::Vector2d(0.5, 0), Eigen::Vector2d(0.2, 0)),
        std::pair(Eigen::Vector2d(0, 0.5), Eigen::Vector2d(0, 0.8)),
        std::pair(Eigen::Vector2d(0.4, 0.4), Eigen::Vector2d(0.1, 0.1)),
        std::pair(Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 0))}) {
    const std::vector<ReferenceCorners> corners = {{a, a + along, a + further},
                                                   {a, a + further, a + along}};
    const SurfaceTextures textures = textures_of(corners, png_of(picture), {});
    const auto expected = reference_colours(kite(), corners, picture, {});
    EXPECT_LE(largest_difference(means_of(kite(), textures), expected), kLevels)
        << along.transpose();
  }
}

TEST(TextureColours, InterlacedRowsInSevenPassesGiveTheSameColours) {
  const Picture picture = noisy_picture(21, 30);
  const auto corners = kite_corners(2.5, {0.1, 0.2});
  for (const TextureWrap wrap : kWraps) {
    const auto rows = means_of(kite(), textures_of(corners, png_of(picture), {wrap, wrap}));
    const auto passes =
        means_of(kite(), textures_of(corners, interlaced_png_of(picture), {wrap, wrap}));
    EXPECT_EQ(rows, passes);
  }
}

TEST(TextureColours, ManyRepetitionsGiveThePicturesMean) {
  const Picture picture = noisy_picture(16, 16);
  for (const double size : {40.0, 3000.0, 900000.0})
    for (const TextureWrap wrap : {TextureWrap::kRepeat, TextureWrap::kMirror}) {
      const auto corners = kite_corners(size, {0.3, 0.3});
      const std::vector<ReferenceCorners> whole = {{Eigen::Vector2d(0, 0), {64, 0}, {0, 64}},
                                                   {Eigen::Vector2d(0, 0), {64, 0}, {0, 64}}};
      EXPECT_LE(
          largest_difference(means_of(kite(), textures_of(corners, png_of(picture), {wrap, wrap})),
                             reference_colours(kite(), whole, picture, {wrap, wrap})),
          2)
          << size;
    }
}

TEST(TextureColours, MeansAreOfLinearLightAndMultipliedByTheFactor) {
  const Picture checks = drawn(64, 64, [](uint32_t x, uint32_t y) {
    const auto level = static_cast<uint8_t>((x + y) % 2 * 255);
    return Rgba8{level, level, level, 255};
  });
  SurfaceTextures textures = textures_of(kite_corners(1, {0, 0}), png_of(checks), {});
  textures.triangles[1].material = kNoTexture;
  textures.materials[0].factor = {1, 0.5F, 0};
  const auto colours = means_of(kite(), textures);
  ASSERT_EQ(colours.size(), 4u);
  EXPECT_NEAR(colours[1][0], 188, 1);
  EXPECT_NEAR(colours[1][1], 137, 1);
  EXPECT_EQ(colours[1][2], 0);
  EXPECT_EQ(colours[3], (Rgba8{255, 255, 255, 255}));
}

TEST(TextureColours, TheMeshesOwnColoursAreMultiplied) {
  TriangleMesh mesh = kite();
  mesh.colours.assign(4, {255, 188, 0, 77});
  const Picture grey = drawn(4, 4, [](uint32_t, uint32_t) { return Rgba8{188, 188, 188, 255}; });
  const SurfaceTextures textures = textures_of(kite_corners(1, {0, 0}), png_of(grey), {});
  EXPECT_LE(
      largest_difference(means_of(mesh, textures), std::vector<Rgba8>(4, Rgba8{188, 137, 0, 77})),
      1);
}

TEST(TextureColours, ACoordinateThatIsNoneOrTooLargeGivesThePlainColour) {
  const std::string file = png_of(noisy_picture(4, 4));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float wrong : {nan, std::numeric_limits<float>::infinity(), 1048577.F, -2e6F}) {
    SurfaceTextures textures = textures_of(kite_corners(1, {0, 0}), file, {});
    textures.materials[0].plain = {1, 0, 0};
    textures.coordinates[textures.triangles[1].corners[2]][1] = wrong;
    EXPECT_EQ(means_of(kite(), textures)[3], (Rgba8{255, 0, 0, 255})) << wrong;
    textures.triangles[1].corners[2] = kNoTexture;
    EXPECT_EQ(means_of(kite(), textures)[3], (Rgba8{255, 0, 0, 255}));
  }
}

TEST(TextureColours, ADamagedPictureCountsAsFarAsItIsReadUnlessItIsRefused) {
  const Picture picture = noisy_picture(40, 40);
  const std::string file = png_of(picture);
  for (const size_t bytes : {size_t{20}, file.size() / 2}) {
    SurfaceTextures textures = textures_of(kite_corners(1, {0, 0}), file.substr(0, bytes), {});
    textures.triangles[1].material = kNoTexture;
    textures.materials[0].plain = {0, 0, 1};
    EXPECT_EQ(means_of(kite(), textures).size(), 4u);
    textures.refuses_damage = true;
    TriangleMesh mesh = kite();
    EXPECT_THAT(add_texture_colours(mesh, textures, {}, "scan").message(), HasSubstr("scan: skin"));
  }
}

TEST(TextureColours, AnotherKindOfPictureGivesThePlainColour) {
  SurfaceTextures textures = textures_of(kite_corners(1, {0, 0}), "GIF89a", {});
  textures.refuses_damage = true;
  textures.triangles[1].material = kNoTexture;
  textures.materials[0].plain = {0, 0, 1};
  EXPECT_EQ(means_of(kite(), textures)[1], (Rgba8{0, 0, 255, 255}));
}

TEST(TextureColours, APictureBeyondTheLimitCountsAsMissing) {
  SurfaceTextures textures = textures_of(kite_corners(1, {0, 0}), "", {});
  textures.pictures.resize(1025, textures.pictures[0]);
  textures.refuses_damage = true;
  textures.triangles[1].material = kNoTexture;
  textures.materials[0].picture = 1024;
  textures.materials[0].plain = {0, 0, 1};
  EXPECT_EQ(means_of(kite(), textures)[1], (Rgba8{0, 0, 255, 255}));
}

}  // namespace
}  // namespace burnish

#include "common/generate/generate.h"
#include "tests/client/raster/twin_stage.h"

namespace burnish {
namespace {

// Both renderers have the same formulas and places of samples. They round places of vertices,
// normals and colours in their own ways: by far less than a step of 255 in the mean.
constexpr double kAlike = 0.0015;
// OpenGL takes a ring's width from differences within blocks of 2x2 pixels.
constexpr double kAlikeRings = 0.008;
// OpenGL takes a flat normal from differences of pixels, whose rounding shows as grain.
constexpr double kAlikeFlat = 0.03;
// OpenGL's edges stand out half a pixel over what lies behind a silhouette.
constexpr double kAlikeEdges = 0.03;

class TwinPicture : public TwinStage {
 protected:
  void SetUp() override {
    TwinStage::SetUp();
    TriangleMesh blob = generate_scan({.kind = "blob", .vertices = 6000}).value();
    for (const Vec3d& at : blob.vertices)
      blob.colours.push_back({static_cast<uint8_t>(at.x() > 0 ? 220 : 60), 120,
                              static_cast<uint8_t>(at.y() > 0 ? 30 : 200), 255});
    show(split_into_pages(blob, 2500));
    camera_.azimuth_degrees = 25;
    camera_.elevation_degrees = 20;
  }

  void wave() {
    move_by([](const Vec3f& at) {
      return Vec3f(0.6f * std::sin(8 * at.y()), 0.8f * std::cos(6 * at.x()), 0.5f * at.x());
    });
  }
};

TEST_F(TwinPicture, EveryLightLooksAsWithOpenGL) {
  const Image clay = draw();
  for (int kind = 0; kind < kLightKinds; ++kind) {
    DrawStyle style;
    style.lighting.kind = static_cast<LightKind>(kind);
    style.lighting.specular = 0.4;
    EXPECT_LT(rmse(style), kAlike) << name_of(style.lighting.kind);
    EXPECT_GT(picture_rmse(draw(style), clay), 2 * kAlike) << name_of(style.lighting.kind);
    style.lighting.occlusion = 0.8;
    EXPECT_LT(rmse(style), kAlike) << name_of(style.lighting.kind) << ", occluded";
  }
}

TEST_F(TwinPicture, EveryColouringLooksAsWithOpenGL) {
  wave();
  mark_by([](const Vec3f& at) {
    return VertexMark{static_cast<int8_t>(127 * std::sin(5 * at.x())), 0, 0};
  });
  const Image clay = draw();
  for (const Colouring colouring :
       {Colouring::kCells, Colouring::kDisplacement, Colouring::kScan}) {
    EXPECT_LT(rmse({.colouring = colouring}), kAlike) << static_cast<int>(colouring);
    EXPECT_GT(picture_rmse(draw({.colouring = colouring}), clay), 2 * kAlike);
  }
}

TEST_F(TwinPicture, ADisplacedSurfaceAndItsOriginalLookAsWithOpenGL) {
  const Image still = draw({.original = true});
  wave();
  EXPECT_LT(rmse(), kAlike);
  EXPECT_GT(picture_rmse(draw(), still), 4 * kAlike);
  EXPECT_EQ(draw({.original = true}).rgb, still.rgb);
}

TEST_F(TwinPicture, TheSplitShowsTheOriginalOnItsLeft) {
  const Image still = draw({.original = true});
  wave();
  const Image moved = draw(), split = draw({.split = 0.37});
  const int middle = split_column(0.37, kTwinSize.width);
  for (int y = 0; y < kTwinSize.height; ++y)
    for (int x = 0; x < kTwinSize.width; ++x) {
      const Image& expected = x < middle ? still : moved;
      ASSERT_TRUE(std::equal(split.pixel(x, y), split.pixel(x, y) + 3, expected.pixel(x, y)))
          << x << " " << y;
    }
}

TEST_F(TwinPicture, TintsOverlaysAndHatchesLookAsWithOpenGL) {
  const Image plain = draw();
  mark_by([](const Vec3f& at) {
    const std::optional<uint32_t> green = at.x() < 0 ? std::optional(0x20c020U) : std::nullopt;
    return VertexMark{0, static_cast<uint8_t>(at.y() < 0 ? 0 : 200),
                      packed_overlay(green, at.z() > 0.2f)};
  });
  const DrawStyle style{.tint = Vec3f(1, 0.2f, 0)};
  EXPECT_LT(rmse(style), kAlike);
  EXPECT_GT(picture_rmse(draw(style), plain), 5 * kAlike);
}

TEST_F(TwinPicture, RingsLookAsWithOpenGL) {
  wave();
  const Vec3d front = split_.rounded.vertices[100];
  const DrawStyle style{.rings = {{front, 0.3 * space_.unit, Vec3f(1, 0, 0)},
                                  {space_.centre, 0.8 * space_.unit, Vec3f(0, 0.5f, 1)}}};
  EXPECT_LT(rmse(style), kAlikeRings);
  EXPECT_GT(picture_rmse(draw(style), draw()), 8 * kAlike);
}

TEST_F(TwinPicture, FlatFadedAndParallelPicturesLookAsWithOpenGL) {
  EXPECT_LT(rmse({.flat = true}), kAlikeFlat);
  EXPECT_LT(rmse({.faded = true}), kAlike);
  camera_.orthographic = true;
  EXPECT_LT(rmse(), kAlike);
  DrawStyle occluded;
  occluded.lighting = {.kind = LightKind::kCavity, .occlusion = 0.8};
  EXPECT_LT(rmse(occluded), kAlike);
}

TEST_F(TwinPicture, EdgesLookMuchAsWithOpenGL) {
  camera_.distance *= 0.4;
  EXPECT_LT(rmse({.wireframe = true}), kAlikeEdges);
  EXPECT_GT(picture_rmse(draw({.wireframe = true}), draw()), kAlikeEdges);
}

TEST_F(TwinPicture, TheInsideOfASurfaceIsLitAsWithOpenGL) {
  std::vector<PatchRange> half = all();
  half.resize(half.size() / 2);
  for (const double azimuth : {0.0, 120.0, 240.0}) {
    camera_.azimuth_degrees = azimuth;
    ASSERT_TRUE(surface_.draw(camera_, kTwinSize, {}, half).is_ok());
    ASSERT_TRUE(gl_surface_->draw(camera_, kTwinSize, {}, half).is_ok());
    EXPECT_LT(picture_rmse(*raster_.read_pixels(), *gl_->read_pixels()), kAlike) << azimuth;
  }
}

TEST_F(TwinPicture, ACameraInsideTheScanSeesWhatOpenGLDoes) {
  for (const double distance : {1.2, 0.9, 0.6, 0.05}) {
    camera_.distance = distance * space_.unit;
    EXPECT_LT(rmse(), kAlike) << distance;
  }
}

TEST_F(TwinPicture, TheNearAndTheFarPlaneCutAsWithOpenGL) {
  const Image whole = draw();
  for (const double radius : {0.7, 0.4, 0.1}) {
    camera_.scene_radius = radius * space_.unit;
    EXPECT_LT(rmse(), kAlike) << radius;
    EXPECT_GT(picture_rmse(draw(), whole), 2 * kAlike) << radius;
  }
}

TEST_F(TwinPicture, OneSampleIsNearAndFourAreNearer) {
  const Image expected = draw_by_gl();
  raster_.set_sampling(RasterSampling::kOne);
  const double of_one = picture_rmse(draw(), expected);
  EXPECT_LT(of_one, 0.02);
  raster_.set_sampling(RasterSampling::kFour);
  EXPECT_LT(picture_rmse(draw(), expected), 0.3 * of_one);
}

}  // namespace
}  // namespace burnish

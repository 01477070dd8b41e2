#include "common/mesh/rewrite/pictures/level_seams.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/archive/archive.h"
#include "common/mesh/rewrite/pictures/texture_charts.h"
#include "common/mesh/rewrite/rewrite.h"
#include "tests/common/archive/packing.h"
#include "tests/common/mesh/rewrite/photo_grid.h"
#include "tests/common/mesh/rewrite/textured_grid.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::string archive_of(const PhotoGrid& grid, const std::string& skin) {
  return as_string(packed({{"scan.obj", grid.obj()}, {"skin.mtl", kSkinMtl}, {"skin.png", skin}}));
}

std::string archive_of(const PhotoGrid& grid) {
  return archive_of(grid, png_of(grid.picture()));
}

/// A scan that is written again with level seams.
struct Levelled {
  std::string file;
  PictureReport report;
  Status status;

  Picture picture() const {
    const Archive opened = std::move(Archive::open(as_bytes(file), "scan")).value();
    return read_picture(opened.read(opened.find("skin.png").value()).value(), "skin").value();
  }
};

Levelled levelled(const std::string& archive, const SeamWish& wish, const FileBudget& budget = {}) {
  const TriangleMesh mesh = parsed(MeshFormat::kZip, archive);
  Levelled result;
  OutputBuffer output([&](std::string_view piece) {
    result.file += piece;
    return Status::ok();
  });
  PictureWork pictures{budget, {}};
  const MovedMesh moved{mesh.vertices, mesh, 0, mesh.colours, {}, wish};
  result.status =
      rewrite_mesh(as_bytes(archive), MeshFormat::kZip, "scan", moved, output, &pictures);
  result.report = pictures.report;
  return result;
}

/// Calls `use` with the surface of an archive.
void with_surface(const std::string& archive,
                  const std::function<void(const TexturedSurface&)>& use) {
  const auto take = [&](const TexturedSurface& surface) {
    use(surface);
    return Status::ok();
  };
  ASSERT_TRUE(read_textured_surface(as_bytes(archive), MeshFormat::kZip, "scan", take).is_ok());
}

TEST(LevelSeams, TheMedianStepFallsToAThirdAtMostAndTheColoursComeCloserToTheTrueOnes) {
  for (const bool is_doubled : {false, true}) {
    const PhotoGrid grid{.has_doubled_corners = is_doubled};
    const Levelled scan = levelled(archive_of(grid), {1});
    ASSERT_TRUE(scan.status.is_ok()) << scan.status.message();
    const Picture before = grid.picture(), after = scan.picture();
    EXPECT_GT(grid.median_step(before), 15);
    EXPECT_LE(grid.median_step(after), 0.3 * grid.median_step(before));
    EXPECT_LT(grid.albedo_error(after), 0.5 * grid.albedo_error(before));
    ASSERT_TRUE(scan.report.seams);
    EXPECT_EQ(scan.report.seams->charts, 9u);
    EXPECT_EQ(scan.report.seams->edges, 48u);
    EXPECT_EQ(scan.report.seams->unknowns, 9u * 25u);
    EXPECT_NEAR(scan.report.seams->median_before, grid.median_step(before), 4);
    EXPECT_LE(scan.report.seams->median_after, 0.4 * scan.report.seams->median_before);
    EXPECT_THAT(text_of(scan.report), HasSubstr("seams of 9 charts levelled"));
  }
}

TEST(LevelSeams, AJpegsSeamsAreLevelledToo) {
  const PhotoGrid grid;
  const std::string skin = jpeg_of(grid.picture(), {.sampling = 1, .quality = 95});
  const Levelled scan = levelled(archive_of(grid, skin), {1});
  ASSERT_TRUE(scan.status.is_ok()) << scan.status.message();
  const double before = grid.median_step(read_picture(as_bytes(skin), "skin").value());
  EXPECT_LE(grid.median_step(scan.picture()), 0.3 * before);
}

TEST(LevelSeams, AnInterlacedPictureGivesTheSameFactors) {
  const PhotoGrid grid;
  std::vector<LevelledSeams> found;
  for (const std::string& skin : {png_of(grid.picture()), interlaced_png_of(grid.picture())})
    with_surface(archive_of(grid, skin), [&](const TexturedSurface& surface) {
      found.push_back(std::move(level_seams(surface, {1})).value());
    });
  ASSERT_EQ(found.size(), 2u);
  for (size_t i = 0; i < found[0].factors.size(); ++i)
    EXPECT_LT((found[0].factors[i] - found[1].factors[i]).norm(), 1e-4);
}

TEST(LevelSeams, HalfOfItIsTheRootOfTheFactors) {
  const std::string archive = archive_of(PhotoGrid());
  with_surface(archive, [](const TexturedSurface& surface) {
    const auto whole = level_seams(surface, {1}), half = level_seams(surface, {0.5});
    ASSERT_TRUE(whole.is_ok() && half.is_ok());
    for (size_t i = 0; i < whole->factors.size(); ++i)
      EXPECT_LT((half->factors[i].cwiseProduct(half->factors[i]) - whole->factors[i]).norm(), 1e-4);
  });
}

TEST(LevelSeams, NothingOfItGivesTheBytesOfTheImport) {
  const std::string archive = archive_of(PhotoGrid());
  const Levelled same = levelled(archive, {0});
  EXPECT_EQ(same.file, archive);
  EXPECT_FALSE(same.report.seams);
}

TEST(LevelSeams, AScanWithOneChartComesBackByteForByte) {
  const std::string archive = archive_of({.blocks = 1, .cells = 12});
  const Levelled same = levelled(archive, {1});
  ASSERT_TRUE(same.status.is_ok()) << same.status.message();
  EXPECT_EQ(same.file, archive);
  EXPECT_EQ(same.report.seams.value_or(SeamReport{}).charts, 1u);
}

TEST(LevelSeams, TheTexelsOfAProtectedRegionStayAndTheOthersComeToThem) {
  const PhotoGrid grid;
  const std::string archive = archive_of(grid);
  const TriangleMesh mesh = parsed(MeshFormat::kZip, archive);
  std::vector<float> free;
  for (const Vec3d& vertex : mesh.vertices) free.push_back(vertex.x() <= 5 ? 0.F : 1.F);
  const Levelled scan = levelled(archive, {1, free});
  ASSERT_TRUE(scan.status.is_ok()) << scan.status.message();
  const Picture before = grid.picture(), after = scan.picture();
  for (double y = 0.1; y < grid.side(); y += 0.2)
    for (double x = 0.1; x < 5; x += 0.2)
      EXPECT_EQ(grid.texel_at(after, {x, y}), grid.texel_at(before, {x, y})) << x << ", " << y;
  const auto step = [&](const Picture& picture) {
    return std::abs(grid.texel_at(picture, {7.9, 6})[0] - grid.texel_at(picture, {8.1, 6})[0]);
  };
  EXPECT_LT(step(after), 0.5 * step(before));
}

TEST(LevelSeams, SidesThatShowDifferentThingsDoNotBleed) {
  const PhotoGrid alike{.contrast = 0};
  PhotoGrid grid = alike;
  Picture picture = grid.picture();
  // The block in the middle shows something white.
  for (double y = 4.01; y < 8; y += 0.02)
    for (double x = 4.01; x < 8; x += 0.02) {
      const auto [u, v] = grid.on_picture(4, x, y);
      picture.pixels[size_t(v) * picture.width + size_t(u)] = {255, 255, 255, 255};
    }
  const Levelled scan = levelled(archive_of(grid, png_of(picture)), {1});
  ASSERT_TRUE(scan.status.is_ok()) << scan.status.message();
  for (const double x : {2.0, 6.0, 10.0})
    for (size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(grid.texel_at(scan.picture(), {x, 6})[i], grid.texel_at(picture, {x, 6})[i], 2);
}

TEST(LevelSeams, AScanWithoutPicturesHasNothingToLevel) {
  const std::string archive =
      as_string(packed({{"scan.obj", PhotoGrid().obj()}, {"skin.mtl", kSkinMtl}}));
  with_surface(archive, [](const TexturedSurface& surface) {
    const auto levelled = level_seams(surface, {1});
    ASSERT_TRUE(levelled.is_ok()) << levelled.status().message();
    EXPECT_EQ(text_of(levelled->report), "no seam between charts to level");
    for (uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) EXPECT_FALSE(levelled->changes(t));
  });
}

TEST(LevelSeams, ADamagedPictureHasNoStepThatCounts) {
  const PhotoGrid grid;
  const std::string archive = archive_of(grid, png_of(grid.picture()).substr(0, 400));
  with_surface(archive, [](const TexturedSurface& surface) {
    const auto levelled = level_seams(surface, {1});
    ASSERT_TRUE(levelled.is_ok()) << levelled.status().message();
    EXPECT_EQ(levelled->report.edges, 0u);
    for (uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) EXPECT_FALSE(levelled->changes(t));
    EXPECT_EQ(text_of(levelled->report), "no seam between charts to level");
  });
}

TEST(LevelSeams, MemoryGrowsWithTheUnknownsAndARefusalEndsTheExport) {
  uint64_t most[2] = {0, 0};
  for (const int i : {0, 1}) {
    const std::string archive = archive_of({.cells = i == 0 ? 4 : 16});
    const auto count = [&](uint64_t bytes) {
      most[i] = std::max(most[i], bytes);
      return Status::ok();
    };
    with_surface(archive, [&](const TexturedSurface& surface) {
      EXPECT_TRUE(level_seams(surface, {1}, count).is_ok());
    });
    const auto refuse = [&](uint64_t bytes) {
      return bytes == most[i] ? resource_exhausted("too much") : Status::ok();
    };
    with_surface(archive, [&](const TexturedSurface& surface) {
      EXPECT_EQ(level_seams(surface, {1}, refuse).status().code(), StatusCode::kResourceExhausted);
    });
  }
  EXPECT_GT(most[0], 9 * 25 * 3 * sizeof(double));
  EXPECT_GT(most[1], most[0] + 9 * (17 * 17 - 25) * 3 * sizeof(double));
}

TEST(LevelSeams, EveryPartHearsACancel) {
  const std::string archive = archive_of(PhotoGrid());
  int asked_in_all = 0;
  const auto count = [&](uint64_t) {
    ++asked_in_all;
    return Status::ok();
  };
  with_surface(archive, [&](const TexturedSurface& surface) {
    ASSERT_TRUE(level_seams(surface, {1}, count).is_ok());
    for (int last = 0; last < asked_in_all; last += 5) {
      int asked = 0;
      const auto cancel = [&](uint64_t) {
        return asked++ >= last ? cancelled("enough") : Status::ok();
      };
      EXPECT_EQ(level_seams(surface, {1}, cancel).status().code(), StatusCode::kCancelled) << last;
    }
  });
  EXPECT_GT(asked_in_all, 20);
}

TEST(LevelSeams, ChartsAreWhatHangsTogetherOnThePicture) {
  with_surface(archive_of({.blocks = 2, .cells = 2}), [](const TexturedSurface& surface) {
    const TextureCharts charts = std::move(find_texture_charts(surface)).value();
    EXPECT_EQ(charts.charts, 4u);
    EXPECT_EQ(charts.point_count(), 4u * 9u);
    ASSERT_EQ(charts.seams.size(), 8u);
    for (const SeamEdge& seam : charts.seams)
      for (size_t end = 0; end < 2; ++end) {
        const auto vertex = [&](const SeamEdge::Side& side) {
          return surface.mesh.triangles[side.triangle][side.corners[end]];
        };
        EXPECT_EQ(vertex(seam.sides[0]), vertex(seam.sides[1]));
      }
  });
}

}  // namespace
}  // namespace burnish

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/evaluation/evaluation.h"
#include "common/generate/generate.h"
#include "common/grid/morton.h"
#include "common/mesh/srgb.h"
#include "server/session/fit_signal.h"
#include "tests/server/session/solved_session.h"

namespace burnish {
namespace {

using testing::HasSubstr;

Rgba8 byte_colour(const Vec3f& linear) {
  return {srgb_byte(linear.x()), srgb_byte(linear.y()), srgb_byte(linear.z()), 255};
}

/// Speckles from vertex to vertex, which the grid does not see, over colours that it does.
TriangleMesh speckled_sphere() {
  std::mt19937 random(3);
  TriangleMesh sphere = make_icosphere(5, 1);
  for (const Vec3d& p : sphere.vertices) {
    const float speckle = random() % 2 == 0 ? 0.06F : -0.06F;
    const Vec3f broad(0.4F + 0.2F * static_cast<float>(p.x()), 0.4F, 0.5F);
    sphere.colours.push_back(byte_colour(broad + Vec3f::Constant(speckle)));
  }
  return sphere;
}

/// Returns the grid's colours at the vertices.
std::vector<Vec3f> fitted_colours(const TriangleMesh& mesh, int depth) {
  PrepareOptions options;
  options.depth = depth;
  const Multigrid on = *make_multigrid(*prepare(mesh, options), {});
  std::vector<Vec3f> values;
  for (const Rgba8& colour : mesh.colours) values.push_back(linear_colour(colour));
  const std::vector<Vec3f> corners = fit_signal(on, values).corners;
  const SparseGrid& grid = on.hierarchy->at(on.hierarchy->finest).grid;
  for (size_t v = 0; v < values.size(); ++v)
    values[v] = evaluate(grid, on.prepared->evaluation[v], std::span<const Vec3f>(corners));
  return values;
}

TEST(Texture, AGainOfOneAndKeptLightChangeNoByte) {
  const TriangleMesh sphere = speckled_sphere();
  const auto session = session_over(sphere, 4);
  EXPECT_EQ(exact_surface(*session, {SetTexture{}}).colours, sphere.colours);
  EXPECT_TRUE(session->texels().empty());
  EXPECT_NE(exact_surface(*session, {SetTexture{{2, 0.5}}}).colours, sphere.colours);
  EXPECT_EQ(exact_surface(*session, {Undo{}}).colours, sphere.colours);
  EXPECT_TRUE(session->texels().empty());
}

TEST(Texture, AGainMultipliesTheDifferenceToTheGridsColours) {
  const TriangleMesh sphere = speckled_sphere();
  const std::vector<Vec3f> fitted = fitted_colours(sphere, 4);
  const auto session = session_over(sphere, 4);
  for (const float gain : {0.F, 0.5F, 2.F}) {
    const TriangleMesh shown = exact_surface(*session, {SetTexture{{gain, 0}}});
    EXPECT_EQ(shown.vertices, sphere.vertices);
    for (size_t v = 0; v < fitted.size(); ++v) {
      const Vec3f before = linear_colour(sphere.colours[v]);
      EXPECT_EQ(shown.colours[v], byte_colour(fitted[v] + gain * (before - fitted[v])));
    }
  }
}

TEST(Texture, TexelsDifferByTheGainFromTheirVertexBeyondBlackToo) {
  const TriangleMesh sphere = speckled_sphere();
  const std::vector<Vec3f> fitted = fitted_colours(sphere, 4);
  const auto session = session_over(sphere, 4);
  exact_surface(*session, {SetTexture{{4, 0}}});
  const std::vector<TexelChange> texels = session->texels();
  int beyond = 0;
  for (size_t v = 0; v < texels.size(); ++v) {
    EXPECT_EQ(texels[v].gain, 4);
    const auto of_vertex = std::pow(static_cast<float>(sphere.colours[v][0]) / 255, 2.2F);
    const float shown = texels[v].gain * of_vertex + texels[v].light.x();
    const float whole = fitted[v].x() + 4 * (linear_colour(sphere.colours[v]).x() - fitted[v].x());
    EXPECT_NEAR(shown, whole, 0.012) << "renderers take another curve for light than sRGB";
    beyond += whole < 0;
  }
  EXPECT_GT(beyond, 10);
}

TEST(Texture, AGainGoesWithAFilterOfColours) {
  const TriangleMesh sphere = speckled_sphere();
  const std::vector<Vec3f> fitted = fitted_colours(sphere, 4);
  const auto session = session_over(sphere, 4);
  const TriangleMesh filtered = exact_surface(*session, {SetColour{{20, 0.5}}});
  const TriangleMesh both = exact_surface(*session, {SetTexture{{1.5, 0}}});
  for (size_t v = 0; v < fitted.size(); ++v) {
    const Vec3f detail = linear_colour(sphere.colours[v]) - fitted[v];
    const Vec3f expected = linear_colour(filtered.colours[v]) + 0.5F * detail;
    EXPECT_LT((linear_colour(both.colours[v]) - expected).cwiseAbs().maxCoeff(), 0.01);
  }
}

/// A scan that was taken in some light.
struct LitScan {
  TriangleMesh scan;
  std::vector<Rgba8> albedo;

  /// Returns how near colours are to the albedo, in decibels.
  double nearness(const std::vector<Rgba8>& colours) const {
    double squares = 0;
    for (size_t v = 0; v < albedo.size(); ++v)
      for (size_t i = 0; i < 3; ++i) squares += std::pow(colours[v][i] - albedo[v][i], 2);
    return 10 * std::log10(255 * 255 * 3.0 * static_cast<double>(albedo.size()) / squares);
  }
};

/// Paints stripes and spots. `light` returns the light at a place of a normal; on average it is 1.
template <typename Light>
LitScan lit(TriangleMesh mesh, const std::vector<Vec3d>& normals, const Light& light) {
  LitScan made{std::move(mesh), {}};
  const MeshStatistics statistics = compute_statistics(made.scan);
  double mean = 0;
  std::vector<double> lights;
  for (size_t v = 0; v < made.scan.vertices.size(); ++v) {
    const Vec3d at = made.scan.vertices[v] / statistics.diagonal();
    lights.push_back(light(at, normals[v]));
    mean += lights.back() / static_cast<double>(normals.size());
  }
  for (size_t v = 0; v < lights.size(); ++v) {
    const Vec3d at = 20 * made.scan.vertices[v] / statistics.diagonal();
    const bool is_spot = std::sin(at.x()) * std::sin(at.y() + 1) * std::cos(at.z()) > 0.3;
    const Vec3f albedo =
        is_spot ? Vec3f(0.25F, 0.05F, 0.04F)
                : Vec3f(0.35F, 0.3F, 0.2F) * static_cast<float>(1 + 0.4 * std::sin(2.7 * at.z()));
    made.albedo.push_back(byte_colour(albedo));
    made.scan.colours.push_back(byte_colour(static_cast<float>(lights[v] / mean) * albedo));
  }
  return made;
}

double light_removed(const LitScan& lit, double strength) {
  const auto session = session_over(lit.scan, 5);
  const TriangleMesh shown = exact_surface(*session, {SetTexture{{1, strength}}});
  return lit.nearness(shown.colours);
}

TEST(RemovedLight, OfASunAndASkyGoesFromARoundScan) {
  TriangleMesh sphere = make_icosphere(5, 1);
  const std::vector<Vec3d> normals = sphere.vertices;
  const Vec3d sun = Vec3d(0.5, 0.6, 0.62).normalized();
  const LitScan scan = lit(std::move(sphere), normals, [&](const Vec3d&, const Vec3d& normal) {
    return 0.75 * std::max(normal.dot(sun), 0.0) + 0.3 + 0.3 * normal.y();
  });
  const double before = scan.nearness(scan.scan.colours), half = light_removed(scan, 0.5),
               after = light_removed(scan, 1);
  EXPECT_GT(after, before + 5);
  EXPECT_GT(half, before + 2);
  EXPECT_GT(after, half);
}

TEST(RemovedLight, OfALampGoesFromAFlatScan) {
  TriangleMesh flat = generate_scan({.kind = "tablet", .vertices = 6000}).value();
  const std::vector<Vec3d> normals(flat.vertices.size(), Vec3d::UnitZ());
  const LitScan scan = lit(std::move(flat), normals, [&](const Vec3d& at, const Vec3d&) {
    const Vec3d way = Vec3d(0.3, 0.3, 0.5) - at;
    return 1 / way.squaredNorm();
  });
  const double before = scan.nearness(scan.scan.colours), after = light_removed(scan, 1);
  EXPECT_GT(after, before + 12);
}

TEST(RemovedLight, OfAnEvenlyLitScanHardlyChangesIt) {
  TriangleMesh sphere = make_icosphere(5, 1);
  const std::vector<Vec3d> normals = sphere.vertices;
  const LitScan scan =
      lit(std::move(sphere), normals, [](const Vec3d&, const Vec3d&) { return 1; });
  EXPECT_GT(light_removed(scan, 1), 32);
}

Stroke texture_stroke(double gain) {
  Stroke stroke{{0.5, 1, gain, FallOff::kConstant}, {Vec3d(0, 0, 1)}};
  stroke.brush.texture = true;
  return stroke;
}

constexpr double kNear = 0.2, kFar = 0.8;  // of that stroke: all cells there are painted, and none

double to_stroke(const Vec3d& place) {
  return (place - Vec3d(0, 0, 1)).norm();
}

TEST(Texture, ABrushPaintsItsGain) {
  const TriangleMesh sphere = speckled_sphere();
  const std::vector<Vec3f> fitted = fitted_colours(sphere, 4);
  const auto session = session_over(sphere, 4);
  const TriangleMesh shown = exact_surface(*session, {texture_stroke(2)});
  const std::vector<TexelChange> texels = session->texels();
  EXPECT_EQ(shown.vertices, sphere.vertices);
  int painted = 0;
  for (size_t v = 0; v < fitted.size(); ++v) {
    if (to_stroke(sphere.vertices[v]) < kNear) {
      const Vec3f before = linear_colour(sphere.colours[v]);
      EXPECT_EQ(shown.colours[v], byte_colour(fitted[v] + 2 * (before - fitted[v])));
      EXPECT_EQ(texels[v].gain, 2);
      ++painted;
    } else if (to_stroke(sphere.vertices[v]) > kFar) {
      EXPECT_EQ(shown.colours[v], sphere.colours[v]);
      EXPECT_TRUE(texels[v].is_none());
    }
  }
  EXPECT_GT(painted, 10);
  EXPECT_EQ(exact_surface(*session, {Undo{}}).colours, sphere.colours);
  EXPECT_TRUE(session->texels().empty());
}

TEST(Texture, PaintCoversTheGainOfTheWholeScan) {
  const TriangleMesh sphere = speckled_sphere();
  const auto session = session_over(sphere, 4);
  const TriangleMesh whole = exact_surface(*session, {SetTexture{{3, 0}}});
  const TriangleMesh shown = exact_surface(*session, {texture_stroke(1)});
  for (size_t v = 0; v < sphere.vertices.size(); ++v) {
    const double away = to_stroke(sphere.vertices[v]);
    if (away > kNear && away < kFar) continue;
    EXPECT_EQ(shown.colours[v], (away < kNear ? sphere : whole).colours[v]);
  }
  EXPECT_EQ(exact_surface(*session, {Undo{}}).colours, whole.colours);
  const TriangleMesh other = exact_surface(*session, {Redo{}, SetTexture{{0.5, 0}}});
  const auto again = session_over(sphere, 4);
  EXPECT_EQ(exact_surface(*again, {SetTexture{{0.5, 0}}, texture_stroke(1)}).colours,
            other.colours);
}

/// Sets the gain of all cells.
SetCellFields texture_cells(const Session& session, double gain) {
  SetCellFields change{{}, CellTarget::kTexture};
  for (const uint64_t cell : session.prepared().cells)
    change.cells.push_back({morton_point(cell), 0, 0, gain});
  return change;
}

TEST(Texture, CellsOfItArePaintAsThatOfABrush) {
  const TriangleMesh sphere = speckled_sphere();
  const auto session = session_over(sphere, 4), other = session_over(sphere, 4);
  const TriangleMesh whole = exact_surface(*other, {SetTexture{{2, 0}}});
  const SetCellFields cells = texture_cells(*session, 2);
  EXPECT_EQ(exact_surface(*session, {cells}).colours, whole.colours);
  const TriangleMesh under = exact_surface(*session, {texture_stroke(1)});
  EXPECT_EQ(exact_surface(*other, {texture_stroke(1)}).colours, under.colours);
  EXPECT_EQ(exact_surface(*session, {Undo{}}).colours, whole.colours);
  EXPECT_EQ(exact_surface(*session, {Undo{}}).colours, sphere.colours);
  const TriangleMesh over = exact_surface(*session, {texture_stroke(1), cells});
  EXPECT_EQ(over.colours, whole.colours);
}

TEST(Texture, PaintOfItNeedsColours) {
  const auto session = session_over(make_icosphere(3, 1));
  const EditedFields& edited = session->edited();
  for (const Change& change : {Change(texture_stroke(2)), Change(texture_cells(*session, 2))}) {
    const Status refused = edited.check_new({"t", change});
    EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
    EXPECT_THAT(refused.message(), HasSubstr("no colours"));
  }
}

TEST(Texture, ABrushPaintsNoMoreThanTheSlider) {
  EXPECT_TRUE(validate(texture_stroke(kTextureGainMax)).is_ok());
  const Status refused = validate(texture_stroke(5));
  EXPECT_EQ(refused.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(refused.message(), HasSubstr("texture gain 5"));
}

TEST(Texture, IsKeptInTheProtectedRegion) {
  const TriangleMesh sphere = speckled_sphere();
  const auto session = session_over(sphere, 4);
  Protect all;
  all.way = PieceRegion{Vec3d(0, 0, 1)};
  EXPECT_EQ(exact_surface(*session, {all, SetTexture{{3, 1}}}).colours, sphere.colours);
}

TEST(Texture, LevelSeamsChangeNoVertexAndSpareTheProtectedRegion) {
  const TriangleMesh sphere = speckled_sphere();
  const auto session = session_over(sphere, 4);
  EXPECT_EQ(session->seams().amount, 0);
  EXPECT_EQ(exact_surface(*session, {SetTexture{{1, 0, 0.5}}}).colours, sphere.colours);
  EXPECT_TRUE(session->texels().empty());
  EXPECT_EQ(session->seams().amount, 0.5);
  EXPECT_TRUE(session->seams().free.empty());
  Protect all;
  all.way = PieceRegion{Vec3d(0, 0, 1)};
  exact_surface(*session, {all});
  EXPECT_EQ(session->seams().free, std::vector<float>(sphere.vertices.size(), 0));
  exact_surface(*session, {Undo{}, Undo{}});
  EXPECT_EQ(session->seams().amount, 0);
}

TEST(Texture, OfAScanWithoutColoursIsRefused) {
  const auto session = session_over(make_icosphere(3, 1));
  const Status refused = session->edited().check_new({"c", SetTexture{{2, 0}}});
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("no colours"));
}

TEST(Texture, AValueOutsideItsLimitsIsNamed) {
  EXPECT_THAT(validate({"t", SetTexture{{4.5, 0}}}).message(),
              HasSubstr("gain 4.5 is outside 0..4"));
  EXPECT_THAT(validate({"t", SetTexture{{1, -0.25}}}).message(),
              HasSubstr("removed light -0.25 is outside 0..1"));
  EXPECT_THAT(validate({"t", SetTexture{{1, 0, 1.5}}}).message(),
              HasSubstr("levelled seams 1.5 is outside 0..1"));
  EXPECT_FALSE(validate({"t", SetTexture{{std::nan(""), 0}}}).is_ok());
}

}  // namespace
}  // namespace burnish

#include "common/denoise/denoise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/denoise/normal_filter.h"
#include "common/denoise/normal_layer.h"
#include "common/generate/generate.h"
#include "common/mesh/statistics/statistics.h"
#include "tests/common/denoise/shape_error.h"
#include "tests/common/odd_triangles.h"
#include "tests/common/split_vertices.h"

namespace burnish {
namespace {

std::vector<Vec3f> layer_of(const TriangleMesh& mesh, const EdgeFilter& filter) {
  const auto surface = make_denoise_surface(mesh);
  EXPECT_TRUE(surface.is_ok());
  auto layer = denoise_layer(**surface, filter);
  EXPECT_TRUE(layer.is_ok()) << layer.status().to_string();
  return *layer;
}

const EdgeFilter& machined() {
  return edge_presets()[0].filter;
}
const EdgeFilter& scanner() {
  return edge_presets()[1].filter;
}

bool are_finite(const std::vector<Vec3f>& moves) {
  return std::ranges::all_of(moves, [](const Vec3f& move) { return move.allFinite(); });
}

/// A sheet with a needle, a triangle without area, and three without a neighbour.
TriangleMesh with_slivers() {
  TriangleMesh mesh = *generate_scan({"sheet", 400, 1, 0.3});
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  const Vec3d p = mesh.vertices[30];
  add(p, p + Vec3d(1, 0, 0), p + Vec3d(0.5, 1e-12, 0));
  add(p, p + Vec3d(1, 0, 0), p + Vec3d(0.5, 0, 0));
  add(p, p + Vec3d(1e-9, 0, 0), p + Vec3d(0, 1e-9, 0));
  add({9, 9, 9}, {9, 9, 9}, {9, 9, 9});
  add({9, 9, 9}, {8, 9, 9}, {9, 8, 9});
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double by) {
  for (Vec3d& p : mesh.vertices) p *= by;
  return mesh;
}

TEST(Denoise, OddMeshesHaveAFiniteLayer) {
  std::vector<TriangleMesh> meshes = {with_slivers()};
  for (const char* kind : {"soup", "fan", "sheets", "wall"})
    meshes.push_back(*generate_scan({kind, 2000}));
  for (const double unit : {1e-12, 1e16}) meshes.push_back(scaled(with_slivers(), unit));
  TriangleMesh one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  meshes.push_back(one);
  for (const TriangleMesh& mesh : meshes)
    for (const EdgePreset& preset : edge_presets()) {
      const std::vector<Vec3f> moves = layer_of(mesh, preset.filter);
      EXPECT_EQ(moves.size(), mesh.vertices.size());
      EXPECT_TRUE(are_finite(moves)) << preset.name;
    }
}

/// Measures what a preset leaves of a noise, with the noise of `deviation` mean edges.
ShapeError error_of(const EdgePreset& preset, const std::string& kind, uint64_t vertices,
                    double deviation, NoiseKind noise) {
  const TriangleMesh clean = *generate_scan({kind, vertices, 1, 0.0});
  const TriangleMesh noisy = *generate_scan({kind, vertices, 1, deviation, noise});
  return shape_error(clean, moved(noisy, layer_of(noisy, preset.filter)));
}

TEST(Denoise, AMachinedPartIsWithinItsBars) {
  for (const uint64_t vertices : {3000, 7000}) {
    const ShapeError error = error_of(edge_presets()[0], "part", vertices, 0.2, NoiseKind::kGauss);
    EXPECT_LT(error.angle, vertices == 7000 ? 1.8 : 2.4);  // 22 before
    EXPECT_LT(error.distance, 0.05);
    EXPECT_LT(std::abs(error.volume), 0.3);
  }
}

TEST(Denoise, APartUnderStructuredLightIsWithinItsBars) {
  const ShapeError error = error_of(edge_presets()[1], "part", 7000, 0.15, NoiseKind::kScanner);
  EXPECT_LT(error.angle, 2.8);  // 10 before
  EXPECT_LT(error.distance, 0.1);
}

TEST(Denoise, ACoinKeepsItsLettersAndLosesNoise) {
  const EdgePreset& relief = edge_presets()[3];
  EXPECT_LT(error_of(relief, "coin", 6400, 0.1, NoiseKind::kGauss).angle, 8.0);  // 11 before
  EXPECT_LT(error_of(relief, "coin", 14'400, 0.1, NoiseKind::kGauss).angle, 6.0);
  EXPECT_LT(error_of(relief, "coin", 14'400, 0.15, NoiseKind::kScanner).angle, 8.0);
}

TEST(Denoise, ASphereIsRound) {
  const ShapeError error = error_of(edge_presets()[1], "icosphere", 10'242, 0.2, NoiseKind::kGauss);
  EXPECT_LT(error.angle, 1);  // 19 before
  EXPECT_LT(error.distance, 0.04);
}

TEST(Denoise, TurnsHardlyATriangleOver) {
  for (const char* kind : {"soup", "fan", "wall"}) {
    const TriangleMesh mesh = *generate_scan({kind, 10'000});
    for (const EdgePreset& preset : edge_presets())
      EXPECT_LE(turned_share(mesh, moved(mesh, layer_of(mesh, preset.filter))), 0.001)
          << kind << ", " << preset.name;
  }
}

TEST(Denoise, AFlatSurfaceStays) {
  const TriangleMesh sheet = make_sheet(20, 5, 0);
  for (const EdgePreset& preset : edge_presets())
    for (const Vec3f& move : layer_of(sheet, preset.filter)) EXPECT_LT(move.norm(), 1e-6);
}

TEST(Denoise, WithoutPassesKeepsTheSurface) {
  const TriangleMesh mesh = *generate_scan({"blob", 2000});
  const auto surface = *make_denoise_surface(mesh);
  const NormalFilter filter(surface->welded, surface->rings, NormalFilterKind::kBilateral, 0.3);
  for (const Vec3f& move : normal_layer(surface->welded, filter.normals()))
    EXPECT_LT(move.norm(), 1e-6);
}

TEST(Denoise, PoseAndUnitChangeNothing) {
  const TriangleMesh mesh = *generate_scan({"part", 5000, 1, 0.2});
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vec3d(1, 2, 3).normalized()).toRotationMatrix();
  const double unit = 2540, diagonal = compute_statistics(mesh).diagonal();
  TriangleMesh other = mesh;
  for (Vec3d& p : other.vertices) p = unit * (turn * p) + Vec3d(5e4, -3e4, 1e4);
  for (const EdgePreset& preset : edge_presets()) {
    const auto here = layer_of(mesh, preset.filter), there = layer_of(other, preset.filter);
    double largest = 0;
    for (size_t v = 0; v < here.size(); ++v)
      largest = std::max(
          largest,
          (turn.transpose() * there[v].cast<double>() / unit - here[v].cast<double>()).norm());
    EXPECT_LT(largest, 1e-6 * diagonal) << preset.name;
  }
}

TEST(Denoise, ASeamOfATextureChangesNothing) {
  const TriangleMesh mesh = *generate_scan({"part", 3000, 1, 0.2});
  const TriangleMesh seamed = with_seam(mesh);
  ASSERT_GT(seamed.vertices.size(), mesh.vertices.size());
  for (const EdgePreset& preset : edge_presets()) {
    const auto joined = layer_of(mesh, preset.filter), split = layer_of(seamed, preset.filter);
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int corner = 0; corner < 3; ++corner)
        ASSERT_EQ(split[seamed.triangles[t][corner]], joined[mesh.triangles[t][corner]]);
  }
}

TEST(Denoise, CopiesOfTrianglesChangeNothing) {
  const TriangleMesh mesh = *generate_scan({"icosphere", 642, 1, 0.2});
  const std::vector<Vec3f> expected = layer_of(mesh, machined());
  for (const auto& [name, odd] : with_triangles_of_no_surface(mesh)) {
    std::vector<Vec3f> found = layer_of(odd, machined());
    found.resize(expected.size());
    EXPECT_EQ(found, expected) << name;
  }
}

TEST(Denoise, HasTheSameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = *generate_scan({"wall", 10'000});
  const int before = thread_count();
  for (const EdgeFilter& filter : {machined(), scanner()}) {
    use_threads(1);
    const std::vector<Vec3f> expected = layer_of(mesh, filter);
    for (const int threads : {2, 3}) {
      use_threads(threads);
      EXPECT_EQ(layer_of(mesh, filter), expected) << threads << " threads";
    }
  }
  use_threads(before);
}

/// Returns FNV-1a over the bits of the moves.
uint64_t hash_of(const std::vector<Vec3f>& moves) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const Vec3f& move : moves)
    for (int axis = 0; axis < 3; ++axis)
      hash = (hash ^ std::bit_cast<uint32_t>(move[axis])) * 0x100000001b3;
  return hash;
}

TEST(Denoise, HasTheSameBitsOnEveryMachine) {
  const TriangleMesh part = *generate_scan({"part", 2000, 1, 0.2, NoiseKind::kGauss});
  EXPECT_EQ(hash_of(layer_of(part, machined())), 0xdf9c374a805c604a);
  EXPECT_EQ(hash_of(layer_of(part, scanner())), 0xf2361079316a75cd);
}

TEST(Denoise, ShowsEachPass) {
  const TriangleMesh mesh = *generate_scan({"blob", 500});
  const auto surface = *make_denoise_surface(mesh);
  std::vector<int> passes;
  const auto show = [&](int pass, std::span<const NormalAndArea> normals) {
    passes.push_back(pass);
    EXPECT_EQ(normals.size(), mesh.triangles.size());
  };
  ASSERT_TRUE(denoise_layer(*surface, {.passes = 3}, {}, {}, show).is_ok());
  EXPECT_THAT(passes, testing::ElementsAre(1, 2, 3));
}

TEST(Denoise, ReportsItsPhases) {
  const TriangleMesh mesh = *generate_scan({"blob", 500});
  std::set<std::string> phases;
  const Progress note = [&](std::string_view phase, double fraction) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    return phases.emplace(phase), true;
  };
  ASSERT_TRUE(denoise_layer(**make_denoise_surface(mesh, {}, note), {}, {}, note).is_ok());
  EXPECT_THAT(phases, testing::UnorderedElementsAre("rings", "normals", "layer"));
}

TEST(Denoise, HearsACancelInEachPhase) {
  const TriangleMesh mesh = *generate_scan({"blob", 500});
  const auto surface = *make_denoise_surface(mesh);
  for (const std::string_view in : {"rings", "normals", "layer"}) {
    const Progress cancel = [&](std::string_view phase, double) { return phase != in; };
    const Status status = in == "rings" ? make_denoise_surface(mesh, {}, cancel).status()
                                        : denoise_layer(*surface, {}, {}, cancel).status();
    EXPECT_EQ(status.code(), StatusCode::kCancelled) << in;
  }
}

TEST(Denoise, AWrongFilterIsRefused) {
  const TriangleMesh mesh = make_icosphere(1, 1);
  const auto surface = *make_denoise_surface(mesh);
  const Status status = denoise_layer(*surface, {.edge_angle = 200}).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), testing::HasSubstr("5..120"));
}

}  // namespace
}  // namespace burnish

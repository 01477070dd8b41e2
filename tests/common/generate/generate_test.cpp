#include "common/generate/generate.h"

#include <bit>
#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/tablet_stone.h"
#include "common/mesh/statistics/statistics.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TriangleMesh generate(const std::string& kind, uint64_t vertices, uint64_t seed = 1) {
  auto mesh = generate_scan({kind, vertices, seed});
  EXPECT_TRUE(mesh.is_ok()) << mesh.status().to_string();
  return mesh.is_ok() ? *mesh : TriangleMesh{};
}

std::string refusal(const std::string& kind, uint64_t vertices) {
  return generate_scan({kind, vertices, 1}).status().to_string();
}

/// Checks that no two triangles pass an edge in the same direction: they would disagree about the
/// outside.
bool is_consistently_oriented(const TriangleMesh& mesh) {
  std::set<std::pair<uint32_t, uint32_t>> directed_edges;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (!directed_edges.emplace(t[i], t[(i + 1) % 3]).second) return false;
  return true;
}

bool is_float(double x) {
  return static_cast<double>(static_cast<float>(x)) == x;
}

bool has_float_positions(const TriangleMesh& mesh) {
  for (const Vec3d& p : mesh.vertices)
    if (!is_float(p.x()) || !is_float(p.y()) || !is_float(p.z())) return false;
  return true;
}

/// Returns FNV-1a over the bits of the floats and the indices.
uint64_t hash_of(const TriangleMesh& mesh) {
  uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](uint32_t bits) {
    for (int shift = 0; shift < 32; shift += 8)
      hash = (hash ^ ((bits >> shift) & 0xff)) * 0x100000001b3;
  };
  for (const Vec3d& p : mesh.vertices)
    for (int axis = 0; axis < 3; ++axis) add(std::bit_cast<uint32_t>(float(p[axis])));
  for (const Triangle& triangle : mesh.triangles)
    for (uint32_t v : triangle) add(v);
  return hash;
}

class EveryKind : public testing::TestWithParam<GeneratedScanKind> {
 protected:
  std::string kind() const { return std::string(GetParam().name); }
};

TEST_P(EveryKind, IsValidAndUsesAllItsVertices) {
  for (uint64_t vertices : {1000, 20'000}) {
    const TriangleMesh mesh = generate(kind(), vertices);
    EXPECT_TRUE(validate(mesh).is_ok()) << validate(mesh).to_string();
    const MeshStatistics statistics = compute_statistics(mesh);
    EXPECT_EQ(statistics.unreferenced_vertices, 0);
    EXPECT_EQ(statistics.zero_area_triangles, 0);
  }
}

TEST_P(EveryKind, HasAboutTheWantedCount) {
  if (kind() == "icosphere") GTEST_SKIP() << "offers the counts 10·4^level + 2 only";
  for (uint64_t vertices : {5000, 20'000, 60'000}) {
    const auto count = static_cast<double>(generate(kind(), vertices).vertices.size());
    EXPECT_NEAR(count, vertices, 0.1 * vertices);
  }
}

TEST_P(EveryKind, IsTheSameForTheSameSeed) {
  const TriangleMesh once = generate(kind(), 3000, 7), again = generate(kind(), 3000, 7);
  EXPECT_EQ(once.vertices, again.vertices);
  EXPECT_EQ(once.triangles, again.triangles);
}

TEST_P(EveryKind, RoundsToFloatUnlessItSaysDouble) {
  const TriangleMesh mesh = generate(kind(), 1000);
  EXPECT_NE(has_float_positions(mesh), mesh.has_double_positions);
}

TEST_P(EveryKind, IsMadeAtItsLeastCount) {
  const std::string message = refusal(kind(), 1);
  const size_t range = message.find("is outside ");
  ASSERT_NE(range, std::string::npos) << message;
  const uint64_t least = std::stoull(message.substr(range + 11));
  EXPECT_TRUE(validate(generate(kind(), least)).is_ok());
}

TEST_P(EveryKind, RefusesCountsOutsideItsLimits) {
  EXPECT_THAT(refusal(kind(), 3), AllOf(HasSubstr("invalid argument"), HasSubstr(kind()),
                                        HasSubstr("of 3 vertices"), HasSubstr("..50000000")));
  EXPECT_THAT(refusal(kind(), 50'000'001),
              AllOf(HasSubstr("of 50000001 vertices"), HasSubstr("..50000000")));
}

TEST_P(EveryKind, IsTheSameSurfaceWithOtherNoise) {
  const TriangleMesh clean = *generate_scan({kind(), 5000, 1, 0.0});
  const TriangleMesh noisy = *generate_scan({kind(), 5000, 1, 0.2});
  EXPECT_EQ(clean.triangles, noisy.triangles);
  ASSERT_EQ(clean.vertices.size(), noisy.vertices.size());
  const Triangle& first = clean.triangles[0];
  const double edge = (clean.vertices[first[1]] - clean.vertices[first[0]]).norm();
  double squares = 0;
  for (size_t v = 0; v < clean.vertices.size(); ++v)
    squares += (noisy.vertices[v] - clean.vertices[v]).squaredNorm();
  const double deviation = std::sqrt(squares / static_cast<double>(clean.vertices.size()));
  EXPECT_GT(deviation, 0.02 * edge);
  EXPECT_LT(deviation, 2 * edge);
}

INSTANTIATE_TEST_SUITE_P(GeneratedScan, EveryKind, testing::ValuesIn(generated_scan_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(GeneratedScan, UnknownKindNamesTheKinds) {
  EXPECT_THAT(refusal("teapot", 1000),
              AllOf(HasSubstr("'teapot'"), HasSubstr("tablet"), HasSubstr("part")));
}

TEST(GeneratedScan, DiffersFromSeedToSeed) {
  for (const char* kind : {"tablet", "blob", "sheets", "fan", "soup"})
    EXPECT_NE(generate(kind, 2000, 1).vertices, generate(kind, 2000, 2).vertices) << kind;
}

TEST(GeneratedScan, HasTheSameBitsOnEveryMachine) {
  EXPECT_EQ(hash_of(generate("tablet", 5000)), 0xd2752895e095a3cc);
  EXPECT_EQ(hash_of(generate("blob", 2000)), 0xb9e2649e85ec825a);
  EXPECT_EQ(hash_of(generate("sheets", 2000)), 0x4d1b6eed05f4725a);
  EXPECT_EQ(hash_of(generate("fan", 2000)), 0x6a1113c0557dbb19);
  EXPECT_EQ(hash_of(generate("soup", 2000)), 0x5469f6c20ad72b8d);
}

TEST(GeneratedScan, NoiseHasAboutTheWantedDeviationOverTheMeanEdge) {
  const TriangleMesh clean = *generate_scan({"icosphere", 40'962, 1, 0.0});
  const TriangleMesh noisy = *generate_scan({"icosphere", 40'962, 1, 0.2});
  EXPECT_TRUE(clean.has_double_positions);
  EXPECT_FALSE(noisy.has_double_positions);
  double squares = 0;
  for (size_t v = 0; v < clean.vertices.size(); ++v)
    squares += (noisy.vertices[v] - clean.vertices[v]).squaredNorm();
  const auto triangles = static_cast<double>(clean.triangles.size());
  const double edge = std::sqrt(16 * std::numbers::pi / triangles / std::numbers::sqrt3);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(clean.vertices.size())), 0.2 * edge,
              0.03 * edge);
}

TEST(GeneratedScan, RefusesNoiseOutsideItsLimits) {
  const std::string message = generate_scan({"sheet", 1000, 1, 1.5}).status().to_string();
  EXPECT_THAT(message, AllOf(HasSubstr("1.5"), HasSubstr("0..1")));
}

double deviation_over_edge(const GeneratedScan& noisy) {
  GeneratedScan clean = noisy;
  clean.noise = 0;
  const TriangleMesh before = *generate_scan(clean), after = *generate_scan(noisy);
  double squares = 0;
  for (size_t v = 0; v < before.vertices.size(); ++v)
    squares += (after.vertices[v] - before.vertices[v]).squaredNorm();
  return std::sqrt(squares / static_cast<double>(before.vertices.size())) /
         compute_statistics(before).mean_edge_length;
}

TEST(GeneratedScan, WhiteNoiseHasItsDeviation) {
  EXPECT_NEAR(deviation_over_edge({"icosphere", 40'962, 1, 0.2, NoiseKind::kGauss}), 0.2, 0.003);
  EXPECT_NEAR(deviation_over_edge({"part", 20'000, 1, 0.1, NoiseKind::kGauss}), 0.1, 0.005);
}

TEST(GeneratedScan, NoiseOfStructuredLightHasItsDeviationAndSteps) {
  const double steps = 0.3 / std::sqrt(12);  // of an even spread over a step
  EXPECT_NEAR(deviation_over_edge({"icosphere", 40'962, 1, 0.15, NoiseKind::kScanner}),
              std::hypot(0.15, steps), 0.01);
}

TEST(GeneratedScan, NoiseLeavesNoGapBetweenTrianglesOfASoup) {
  const auto with = [](NoiseKind kind) {
    return compute_statistics(*generate_scan({"soup", 3600, 1, 0.1, kind}));
  };
  const auto clean = compute_statistics(*generate_scan({"soup", 3600, 1, 0.0}));
  for (const NoiseKind kind : {NoiseKind::kGauss, NoiseKind::kScanner}) {
    EXPECT_EQ(with(kind).boundary_edges, clean.boundary_edges);
    EXPECT_EQ(with(kind).components, clean.components);
  }
}

TEST(GeneratedScan, NoiseHasTheSameBitsOnEveryMachine) {
  EXPECT_EQ(hash_of(*generate_scan({"part", 2000, 1, 0.2, NoiseKind::kGauss})), 0xf5552afdf434e303);
  EXPECT_EQ(hash_of(*generate_scan({"coin", 2500, 1, 0.15, NoiseKind::kScanner})),
            0x93536cdfd0dd6a75);
}

TEST(GeneratedScan, NoiseHasAWord) {
  EXPECT_EQ(*parse_noise_kind("gauss"), NoiseKind::kGauss);
  EXPECT_EQ(*parse_noise_kind("scanner"), NoiseKind::kScanner);
  EXPECT_EQ(*parse_noise_kind("range"), NoiseKind::kRange);
  EXPECT_THAT(parse_noise_kind("pink").status().message(), HasSubstr("'pink'"));
}

TEST(GeneratedCoin, LettersRiseOverTheField) {
  const TriangleMesh coin = generate("coin", 40'000);
  EXPECT_EQ(compute_statistics(coin).components, 1);
  EXPECT_TRUE(is_consistently_oriented(coin));
  const auto relief = [](const Vec3d& p) {
    return p.z() - 0.06 * (1 - 2 * (p.head<2>() - Eigen::Vector2d(0.5, 0.5)).squaredNorm());
  };
  double level = 0, raised = 0, letters = 0;
  for (const Vec3d& p : coin.vertices) {
    EXPECT_GT(relief(p), -1e-12);
    EXPECT_LT(relief(p), 0.035 + 1e-12);
    level += relief(p) < 1e-6;
    raised += relief(p) > 0.034;
    letters += relief(p) > 0.015 && p.y() > 0.55 && p.y() < 0.8 && p.x() > 0.2 && p.x() < 0.8;
  }
  EXPECT_GT(level, 0.5 * 40'000);
  EXPECT_GT(raised, 0.05 * 40'000);
  EXPECT_GT(letters, 0.02 * 40'000);
}

TEST(GeneratedTablet, LettersAreCutAsDeepAsTheyAreSaidToBe) {
  const TriangleMesh mesh = *generate_scan({"tablet", 100'000, 1, 0.0});
  const TabletStone stone = generated_tablet_stone(1);
  double letters = 0, beside = 0;
  int letter_count = 0, beside_count = 0;
  for (const Vec3d& p : mesh.vertices) {
    const auto depth = p.z() > -15 ? stone.letter_depth(p.head<2>()) : std::nullopt;
    if (depth && *depth > 1.4) letters += p.z(), ++letter_count;
    if (depth && *depth == 0) beside += p.z(), ++beside_count;
  }
  ASSERT_GT(letter_count, 100);
  ASSERT_GT(beside_count, 100);
  EXPECT_NEAR(beside / beside_count - letters / letter_count, 2, 0.4);
}

TEST(GeneratedTablet, IsManifoldWithBoundary) {
  for (uint64_t seed : {1, 2, 3, 4, 5}) {
    const TriangleMesh mesh = generate("tablet", 20'000, seed);
    const MeshStatistics statistics = compute_statistics(mesh);
    EXPECT_EQ(statistics.non_manifold_edges, 0);
    EXPECT_GT(statistics.boundary_edges, 0);
    EXPECT_EQ(statistics.components, 1);
    EXPECT_TRUE(is_consistently_oriented(mesh));
    // A boundary that passes a vertex twice has more edges than vertices.
    std::set<uint32_t> boundary_vertices;
    std::set<std::pair<uint32_t, uint32_t>> directed;
    for (const Triangle& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) directed.emplace(t[i], t[(i + 1) % 3]);
    for (const auto& [a, b] : directed)
      if (!directed.contains({b, a})) boundary_vertices.insert({a, b});
    EXPECT_EQ(boundary_vertices.size(), statistics.boundary_edges);
  }
}

TEST(GeneratedTablet, HasAtLeastTheDemosCount) {
  EXPECT_GE(generate("tablet", 300'000).vertices.size(), 300'000u);
}

TEST(GeneratedTablet, FacesUp) {
  const TriangleMesh mesh = generate("tablet", 20'000);
  double upward = 0, downward = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d edge = mesh.vertices[b] - mesh.vertices[a];
    const double z = edge.cross(mesh.vertices[c] - mesh.vertices[a]).z() / 2;
    (z > 0 ? upward : downward) += std::abs(z);
  }
  EXPECT_GT(upward, 5 * downward);
}

TEST(GeneratedTablet, IsEngravedDeeperThanItIsNoisy) {
  const TriangleMesh mesh = generate("tablet", 100'000);
  size_t level = 0, engraved = 0;
  for (const Vec3d& p : mesh.vertices) {
    if (p.head<2>().norm() > 150) continue;  // well inside: no rim, no chips
    level += p.z() > -1.2;
    engraved += p.z() < -2;
  }
  EXPECT_GT(engraved, 1000u);
  EXPECT_GT(level, 5 * engraved);
}

TEST(GeneratedBlob, IsClosedWithPositiveVolume) {
  for (uint64_t vertices : {26, 20'000}) {
    const TriangleMesh mesh = generate("blob", vertices);
    const MeshStatistics statistics = compute_statistics(mesh);
    EXPECT_TRUE(statistics.is_closed());
    EXPECT_EQ(statistics.non_manifold_edges, 0);
    EXPECT_EQ(statistics.components, 1);
    EXPECT_GT(statistics.signed_volume, 0);
    EXPECT_TRUE(is_consistently_oriented(mesh));
  }
}

TEST(GeneratedSheets, AreTwoAndCloserThanACellAtDepthEight) {
  const TriangleMesh mesh = generate("sheets", 20'000);
  EXPECT_EQ(compute_statistics(mesh).components, 2);
  const size_t sheet = mesh.vertices.size() / 2;
  const double cell = 1 / 0.9 / 256;
  for (size_t v = 0; v < sheet; ++v) {
    const double gap = mesh.vertices[v].z() - mesh.vertices[sheet + v].z();
    ASSERT_GT(gap, 0);
    ASSERT_LT(gap, cell);
  }
}

TEST(GeneratedFan, HasANonManifoldSpine) {
  const MeshStatistics statistics = compute_statistics(generate("fan", 5 * 20 * 20));
  EXPECT_EQ(statistics.non_manifold_edges, 20);
  EXPECT_EQ(statistics.components, 1);
}

TEST(GeneratedSoup, SharesNoVertices) {
  const TriangleMesh mesh = generate("soup", 3600);
  EXPECT_EQ(mesh.vertices.size(), 3 * mesh.triangles.size());
  std::vector<int> uses(mesh.vertices.size(), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const uint32_t v : triangle) ++uses[v];
  EXPECT_THAT(uses, testing::Each(1));
  EXPECT_LT(compute_statistics(mesh).components, 10);  // its triangles meet at places
}

TEST(GeneratedWall, IsClosedAndTornWithSpecksAndNonManifoldEdges) {
  const MeshStatistics statistics = compute_statistics(generate("wall", 40'000));
  EXPECT_EQ(statistics.boundary_edges, 0);
  EXPECT_GT(statistics.non_manifold_edges, 5);
  EXPECT_GT(statistics.components, 15);
}

TEST(GeneratedPart, IsClosedWithOneHoleThroughIt) {
  const TriangleMesh mesh = generate("part", 10'000);
  const MeshStatistics statistics = compute_statistics(mesh);
  EXPECT_TRUE(statistics.is_closed());
  EXPECT_TRUE(is_consistently_oriented(mesh));
  const auto vertices = static_cast<int64_t>(mesh.vertices.size());
  const auto triangles = static_cast<int64_t>(mesh.triangles.size());
  EXPECT_EQ(vertices - triangles / 2, 0) << "Euler's characteristic of a torus";
  const double plate = 14.4 * 10 * 2, boss = M_PI * 9 * 2, hole = M_PI * 1.5 * 1.5 * 4;
  EXPECT_NEAR(statistics.signed_volume, plate + boss - hole, 0.03);
}

TEST(GeneratedPart, HasFacesInGridPlanesAtDepthFour) {
  const TriangleMesh mesh = generate("part", 10'000);
  const MeshStatistics statistics = compute_statistics(mesh);
  const double cell = (statistics.box_max - statistics.box_min).maxCoeff() / 0.9 / 16;
  const double centre = (statistics.box_max.z() + statistics.box_min.z()) / 2;
  std::set<double> levels;
  for (const Triangle& t : mesh.triangles) {
    const double z = mesh.vertices[t[0]].z();
    if (mesh.vertices[t[1]].z() == z && mesh.vertices[t[2]].z() == z) levels.insert(z);
  }
  ASSERT_EQ(levels.size(), 3u);
  for (double z : levels) {
    const double in_cells = (z - centre) / cell;
    EXPECT_NEAR(in_cells, std::round(in_cells), 1e-14);
  }
}

TEST(Icosphere, HasItsVerticesOnTheSphere) {
  const TriangleMesh mesh = make_icosphere(4, 2.5);
  EXPECT_EQ(mesh.vertices.size(), 10u * 256 + 2);
  for (const Vec3d& p : mesh.vertices) ASSERT_NEAR(p.norm(), 2.5, 1e-15 * 2.5);
}

TEST(Icosphere, IsClosedAndFacesOutwards) {
  for (int level : {0, 1, 3}) {
    const TriangleMesh mesh = make_icosphere(level, 1);
    EXPECT_EQ(mesh.triangles.size(), size_t{20} << (2 * level));
    EXPECT_TRUE(compute_statistics(mesh).is_closed());
    EXPECT_TRUE(is_consistently_oriented(mesh));
    EXPECT_GT(compute_statistics(mesh).signed_volume, 0);
  }
}

TEST(Icosphere, ApproachesTheSpheresAreaAndVolume) {
  const MeshStatistics statistics = compute_statistics(make_icosphere(6, 1));
  EXPECT_NEAR(statistics.area, 4 * M_PI, 1e-3 * 4 * M_PI);
  EXPECT_NEAR(statistics.signed_volume, 4 * M_PI / 3, 1e-3 * 4 * M_PI / 3);
}

TEST(Icosphere, IsTheLevelNearestToTheWish) {
  EXPECT_EQ(generate("icosphere", 12).vertices.size(), 12u);
  EXPECT_EQ(generate("icosphere", 401).vertices.size(), 162u);
  EXPECT_EQ(generate("icosphere", 403).vertices.size(), 642u);
  EXPECT_EQ(generate("icosphere", 642).vertices.size(), 642u);
}

TEST(Cylinder, HasItsVerticesOnTheCylinderAndFacesOutwards) {
  const TriangleMesh mesh = make_cylinder(48, 10, 3, 8);
  EXPECT_EQ(mesh.vertices.size(), 48u * 11);
  for (const Vec3d& p : mesh.vertices) ASSERT_NEAR(p.head<2>().norm(), 3, 1e-15 * 3);
  const MeshStatistics statistics = compute_statistics(mesh);
  EXPECT_EQ(statistics.box_min.z(), -4);
  EXPECT_EQ(statistics.box_max.z(), 4);
  EXPECT_EQ(statistics.boundary_edges, 2 * 48);
  EXPECT_TRUE(is_consistently_oriented(mesh));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d edge = mesh.vertices[b] - mesh.vertices[a];
    const Vec3d normal = edge.cross(mesh.vertices[c] - mesh.vertices[a]);
    ASSERT_GT(normal.head<2>().dot(mesh.vertices[a].head<2>()), 0);
  }
}

TEST(Sheet, IsFlatWithoutABump) {
  const TriangleMesh mesh = make_sheet(10, 5, 0);
  const MeshStatistics statistics = compute_statistics(mesh);
  EXPECT_NEAR(statistics.area, 25, 1e-13);
  EXPECT_EQ(statistics.box_min, Vec3d(0, 0, 0));
  EXPECT_EQ(statistics.box_max, Vec3d(5, 5, 0));
  EXPECT_EQ(statistics.boundary_edges, 40);
}

TEST(Sheet, HasItsBumpInTheMiddle) {
  const TriangleMesh mesh = make_sheet(20, 2, 0.3);
  const Vec3d& middle = mesh.vertices[10 * 21 + 10];
  EXPECT_EQ(middle, Vec3d(1, 1, 0.3));
  const Vec3d& one_deviation_off = mesh.vertices[10 * 21 + 12];
  EXPECT_NEAR(one_deviation_off.z(), 0.3 * std::exp(-0.5), 1e-15);
}

}  // namespace
}  // namespace burnish

#include "common/denoise/noise_estimate.h"

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/denoise/mean_side.h"
#include "common/generate/generate.h"
#include "tests/common/odd_triangles.h"
#include "tests/common/split_vertices.h"

namespace burnish {
namespace {

double deviation_of(const TriangleMesh& mesh) {
  return noise_deviation(WeldedSurface(mesh));
}

/// Returns the estimate for a shape with noise of so many mean edges, over the clean mean edge.
double estimate(const char* kind, double deviation, NoiseKind noise = NoiseKind::kGauss) {
  const TriangleMesh clean = *generate_scan({kind, 8000, 1, 0.0});
  return deviation_of(*generate_scan({kind, 8000, 1, deviation, noise})) /
         mean_side(WeldedSurface(clean));
}

TEST(NoiseEstimate, IsWithinAFifthOnAnyShape) {
  for (const char* kind : {"icosphere", "sheet", "part"})
    for (const double deviation : {0.1, 0.2, 0.3})
      EXPECT_NEAR(estimate(kind, deviation), deviation, 0.2 * deviation) << kind;
}

TEST(NoiseEstimate, CountsLettersForLittle) {
  for (const double deviation : {0.1, 0.2, 0.3})
    EXPECT_NEAR(estimate("coin", deviation), deviation, 0.03) << deviation;
}

TEST(NoiseEstimate, IsNothingOnAnExactShape) {
  for (const char* kind : {"icosphere", "sheet", "cylinder", "part", "coin"})
    EXPECT_LT(estimate(kind, 0), 0.002) << kind;
}

TEST(NoiseEstimate, SeesHalfOfStructuredLight) {
  for (const char* kind : {"icosphere", "sheet", "part", "coin"}) {
    EXPECT_GT(estimate(kind, 0.2, NoiseKind::kScanner), 0.04) << kind;
    EXPECT_LT(estimate(kind, 0.2, NoiseKind::kScanner), 0.15) << kind;
  }
}

TEST(NoiseEstimate, ASeamAndCopiesOfTrianglesChangeNothing) {
  const TriangleMesh mesh = *generate_scan({"part", 3000, 1, 0.2});
  const double expected = deviation_of(mesh);
  EXPECT_EQ(deviation_of(with_seam(mesh)), expected);
  for (const auto& [name, odd] : with_triangles_of_no_surface(mesh))
    EXPECT_EQ(deviation_of(odd), expected) << name;
}

TEST(NoiseEstimate, GoesWithTheUnit) {
  TriangleMesh mesh = *generate_scan({"coin", 3000, 1, 0.2});
  const double here = deviation_of(mesh);
  for (Vec3d& p : mesh.vertices) p *= 1024;
  EXPECT_EQ(deviation_of(mesh), 1024 * here);
}

TEST(NoiseEstimate, IsNothingWherePlacesMeetNoThreeTriangles) {
  TriangleMesh one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  EXPECT_EQ(deviation_of(one), 0);
}

TEST(NoiseEstimate, HasTheSameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = *generate_scan({"blob", 8000, 1, 0.2});
  const int before = thread_count();
  use_threads(1);
  const double expected = deviation_of(mesh);
  use_threads(3);
  EXPECT_EQ(deviation_of(mesh), expected);
  use_threads(before);
}

}  // namespace
}  // namespace burnish

#include "common/denoise/edge_proposal.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/common/denoise/shape_error.h"

namespace burnish {
namespace {

EdgeProposal proposal_for(const TriangleMesh& mesh) {
  auto proposal = propose_edges(**make_denoise_surface(mesh));
  EXPECT_TRUE(proposal.is_ok()) << proposal.status().to_string();
  return *proposal;
}

TriangleMesh noisy(const char* kind, double deviation) {
  return *generate_scan({kind, 8000, 1, deviation, NoiseKind::kGauss});
}

TEST(EdgeProposal, PartsAreMachinedAndNothingElseIs) {
  for (const double deviation : {0.1, 0.2, 0.3}) {
    EXPECT_TRUE(proposal_for(noisy("part", deviation)).is_machined) << deviation;
    for (const char* kind : {"coin", "tablet", "blob", "icosphere", "sheet"})
      EXPECT_FALSE(proposal_for(noisy(kind, deviation)).is_machined) << kind << deviation;
  }
}

TEST(EdgeProposal, MoreNoiseGetsMorePasses) {
  for (const char* kind : {"coin", "tablet", "blob"}) {
    int before = 0;
    for (const double deviation : {0.05, 0.1, 0.2, 0.3}) {
      const EdgeFilter filter = proposal_for(noisy(kind, deviation)).filter;
      EXPECT_TRUE(check_edge_filter(filter).is_ok());
      EXPECT_GE(filter.passes, before) << kind << deviation;
      before = filter.passes;
    }
    EXPECT_GT(before, 4) << kind;
  }
}

TEST(EdgeProposal, WithoutNoiseIsOff) {
  for (const char* kind : {"icosphere", "sheet", "part"}) {
    const EdgeProposal proposal = proposal_for(*generate_scan({kind, 8000, 1, 0.0}));
    EXPECT_FALSE(proposal.filter.is_on()) << kind;
    EXPECT_THAT(text_of(proposal), testing::HasSubstr("too little")) << kind;
  }
}

TEST(EdgeProposal, ItsLayerIsNearerToTheCleanShapeThanTheScan) {
  for (const char* kind : {"part", "coin", "tablet", "blob", "icosphere"}) {
    const TriangleMesh clean = *generate_scan({kind, 8000, 1, 0.0});
    for (const double deviation : {0.05, 0.1, 0.2}) {
      const TriangleMesh scan = noisy(kind, deviation);
      const EdgeFilter filter = proposal_for(scan).filter;
      const auto layer = *denoise_layer(**make_denoise_surface(scan), filter);
      EXPECT_LT(shape_error(clean, moved(scan, layer, filter.crispness)).angle,
                shape_error(clean, scan).angle)
          << kind << deviation;
    }
  }
}

TEST(EdgeProposal, NoiseAloneIsTheSameNoise) {
  const TriangleMesh mesh = *generate_scan({"blob", 4000, 1, 0.1, NoiseKind::kGauss});
  const auto alone = measure_noise(mesh);
  ASSERT_TRUE(alone.is_ok());
  const EdgeProposal whole = proposal_for(mesh);
  EXPECT_EQ(alone->noise, whole.noise);
  EXPECT_EQ(alone->mean_edge, whole.mean_edge);
  EXPECT_FALSE(alone->filter.is_on());
  const Progress cancel = [](std::string_view, double) { return false; };
  EXPECT_EQ(measure_noise(mesh, {}, cancel).status().code(), StatusCode::kCancelled);
}

TEST(EdgeProposal, SaysTheNoiseInTheScansUnitAndInEdges) {
  TriangleMesh mesh = *generate_scan({"icosphere", 8000, 1, 0.1, NoiseKind::kGauss});
  for (Vec3d& p : mesh.vertices) p *= 100;
  EXPECT_THAT(text_of(proposal_for(mesh)),
              testing::StartsWith("noise about 0.39 (0.10 mean edges)"));
}

TEST(EdgeProposal, OddMeshesGetOneToo) {
  for (const char* kind : {"soup", "fan", "sheets", "wall"})
    EXPECT_TRUE(check_edge_filter(proposal_for(*generate_scan({kind, 2000})).filter).is_ok());
  TriangleMesh one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  EXPECT_FALSE(proposal_for(one).filter.is_on());
}

TEST(EdgeProposal, TakesNoMoreThanIsPredicted) {
  for (const char* kind : {"part", "blob", "soup", "fan", "wall"}) {
    const TriangleMesh mesh = *generate_scan({kind, 8000, 1, 0.2, NoiseKind::kGauss});
    const ScratchSpace space;
    uint64_t most = 0;
    const Progress look = [&](std::string_view, double) {
      most = std::max(most, space.memory_bytes());
      return true;
    };
    const auto surface = *make_denoise_surface(mesh, space, look);
    ASSERT_TRUE(propose_edges(*surface, space, look).is_ok());
    const uint64_t predicted = predict_proposal_bytes(*surface).arrays;
    EXPECT_LE(most, predicted) << kind;
    EXPECT_GT(2 * most, predicted) << kind;
  }
  const TriangleMesh blob = noisy("blob", 0.2);
  EXPECT_NEAR(double(predict_proposal_bytes(MeshView(blob)).arrays) /
                  double(predict_proposal_bytes(**make_denoise_surface(blob)).arrays),
              1, 0.05);
}

TEST(EdgeProposal, HearsACancel) {
  const TriangleMesh mesh = noisy("blob", 0.2);
  const auto surface = *make_denoise_surface(mesh);
  for (const std::string_view in : {"noise", "edges"}) {
    const Progress cancel = [&](std::string_view phase, double) { return phase != in; };
    EXPECT_EQ(propose_edges(*surface, {}, cancel).status().code(), StatusCode::kCancelled) << in;
  }
}

}  // namespace
}  // namespace burnish

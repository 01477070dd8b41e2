#include "common/denoise/edge_proposal.h"

#include <algorithm>
#include <cmath>

#include "common/denoise/heard_blocks.h"
#include "common/denoise/mean_side.h"
#include "common/denoise/noise_estimate.h"
#include "common/denoise/normal_filter.h"
#include "common/denoise/unless_left.h"

namespace burnish {
namespace {

constexpr double kNoiseMin = 0.02;  // mean edges; the least that a pass takes without more detail
constexpr double kPassesPerEdge = 20;
// Noise of so many mean edges turns normals across an edge angle of 35 degrees, and beyond.
constexpr double kTurningNoise = 0.1, kWholeTurningNoise = 0.2;
constexpr double kSharpPerGentle = 5;  // the wrong preset for parts costs more than a missed one
constexpr double kCosGentle = 0.984807753, kCosSharp = 0.258819045;  // of 10 and of 75 degrees

const EdgeFilter& machined() {
  static const EdgeFilter filter = find_edge_preset("machined")->filter;
  return filter;
}

bool meet_at_an_edge(const Triangle& one, const Triangle& other) {
  int common = 0;
  for (const uint32_t place : one) common += std::ranges::count(other, place) > 0;
  return common == 2;
}

/// Returns how many pairs of neighbours of triangle t, or of its later ones, bend by an angle whose
/// cosine is in (from, to].
int bends_between(const DenoiseSurface& surface, std::span<const NormalAndArea> normals, size_t t,
                  double from, double to) {
  int bends = 0;
  for (const uint32_t other : surface.rings[t]) {
    if (other < t || !meet_at_an_edge(surface.welded.triangle(t), surface.welded.triangle(other)))
      continue;
    const double cosine = normal_of(normals[t]).dot(normal_of(normals[other]));
    bends += from < cosine && cosine <= to;
  }
  return bends;
}

bool is_machined(const DenoiseSurface& surface, const ScratchSpace& space, const LoopPart& part) {
  NormalFilter filter(surface.welded, surface.rings, machined().kind, machined().sigma(), space,
                      part.of(0, 0.2));
  for (int pass = 0; pass < machined().passes; ++pass)
    filter.pass(part_of_pass(part.of(0.2, 0.9), pass, machined().passes));
  const auto count = [&](double from, double to, const LoopPart& counting) {
    return heard_sum(counting, surface.rings.size(), [&](size_t t) {
      return static_cast<double>(bends_between(surface, filter.normals(), t, from, to));
    });
  };
  const double sharp = count(-2, kCosSharp, part.of(0.9, 0.95));
  const double gentle = count(kCosSharp, kCosGentle, part.of(0.95, 1));
  return sharp > kSharpPerGentle * gentle;
}

EdgeFilter few_passes(double noise_in_edges) {
  const double turning =
      std::clamp((noise_in_edges - kTurningNoise) / (kWholeTurningNoise - kTurningNoise), 0.0, 1.0);
  const EdgeFilter narrow = find_edge_preset("scanner")->filter;
  const EdgeFilter wide = find_edge_preset("soft")->filter;
  EdgeFilter filter = narrow;
  filter.edge_angle = std::round(std::lerp(narrow.edge_angle, wide.edge_angle, turning));
  filter.passes =
      std::clamp(static_cast<int>(std::lround(kPassesPerEdge * noise_in_edges)), 1, narrow.passes);
  filter.crispness = std::round(100 * std::lerp(0.5, 1.0, turning)) / 100;
  return filter;
}

EdgeProposal noise_of(const WeldedSurface& surface, const LoopPart& part) {
  EdgeProposal proposal;
  proposal.noise = noise_deviation(surface, part.of(0, 0.9));
  proposal.mean_edge = mean_side(surface, part.of(0.9, 1));
  return proposal;
}

EdgeProposal proposed(const DenoiseSurface& surface, const ScratchSpace& space,
                      const Progress& progress) {
  const LoopPart noise = {progress, "noise"}, edges = {progress, "edges"};
  EdgeProposal proposal = noise_of(surface.welded, noise);
  if (proposal.noise_in_edges() < kNoiseMin) return proposal;
  proposal.is_machined = is_machined(surface, space, edges);
  proposal.filter = proposal.is_machined ? machined() : few_passes(proposal.noise_in_edges());
  return proposal;
}

}  // namespace

Result<EdgeProposal> propose_edges(const DenoiseSurface& surface, const ScratchSpace& space,
                                   const Progress& progress) {
  return unless_left([&] { return proposed(surface, space, progress); });
}

Result<EdgeProposal> measure_noise(const MeshView& mesh, const ScratchSpace& space,
                                   const Progress& progress) {
  return unless_left([&] {
    const LoopPart noise = {progress, "noise"};
    return noise_of(WeldedSurface(mesh, space, noise.of(0, 0.5)), noise.of(0.5, 1));
  });
}

// Peaks while a guided filter is made: the surface, its rings, nearness, normals and guides.
static ProposalBytes proposal_bytes(uint64_t vertices, uint64_t triangles, uint64_t pairs) {
  constexpr uint64_t kSurfacePerTriangle = 33, kSurfacePerVertex = 12, kPerPair = 4;
  constexpr uint64_t kFilterPerTriangle = 88, kNoisePerVertex = 32;
  constexpr uint64_t kEnds = 64;  // rows have one start more
  const uint64_t surface =
      triangles * kSurfacePerTriangle + vertices * kSurfacePerVertex + pairs * kPerPair + kEnds;
  return {surface + triangles * kFilterPerTriangle + pairs * kPerPair, vertices * kNoisePerVertex};
}

ProposalBytes predict_proposal_bytes(const MeshView& mesh) {
  constexpr uint64_t kPairsPerTriangle = 12;
  const uint64_t triangles = mesh.triangles.size();
  return proposal_bytes(mesh.vertices.size(), triangles, kPairsPerTriangle * triangles);
}

ProposalBytes predict_proposal_bytes(const DenoiseSurface& surface) {
  return proposal_bytes(surface.welded.vertex_count(), surface.welded.triangle_count(),
                        surface.rings.pair_count());
}

}  // namespace burnish

#include "tests/system/letters.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/base/check.h"
#include "common/generate/tablet_stone.h"

namespace burnish {

static TriangleMesh tablet(uint64_t vertices, uint64_t seed, double noise, NoiseKind kind) {
  auto mesh = generate_scan({"tablet", vertices, seed, noise, kind});
  BURNISH_CHECK(mesh.is_ok(), "the tablet is generated");
  return std::move(mesh).value();
}

NoisyTablet::NoisyTablet(uint64_t vertices, double noise, NoiseKind kind, uint64_t seed)
    : noisy_(tablet(vertices, seed, noise, kind)), mirrored_(tablet(vertices, seed, 0, kind)) {
  constexpr double kFaceLow = -15, kMiddleDepth = 1.4;
  const TabletStone stone = generated_tablet_stone(seed);
  for (uint32_t v = 0; v < noisy_.vertices.size(); ++v) {
    const Vec3d p = mirrored_.vertices[v];
    const auto depth = p.z() > kFaceLow ? stone.letter_depth(p.head<2>()) : std::nullopt;
    if (depth && *depth > kMiddleDepth) letters_.push_back(v);
    if (depth && *depth == 0) beside_.push_back(v);
    mirrored_.vertices[v] = 2 * p - noisy_.vertices[v];
  }
  BURNISH_CHECK(!letters_.empty() && !beside_.empty(), "the tablet has its inscription");
}

static double mean_height(const std::vector<Vec3d>& points, const std::vector<uint32_t>& of) {
  double sum = 0;
  for (const uint32_t v : of) sum += points[v].z();
  return sum / static_cast<double>(of.size());
}

LetterContrast NoisyTablet::contrast(const std::vector<Vec3d>& noisy_edited,
                                     const std::vector<Vec3d>& mirrored_edited) const {
  LetterContrast result;
  result.contrast = mean_height(noisy_edited, beside_) - mean_height(noisy_edited, letters_);
  double squares = 0;
  for (const auto* part : {&letters_, &beside_})
    for (const uint32_t v : *part) {
      const double difference = (noisy_edited[v].z() - mirrored_edited[v].z()) / 2;
      squares += difference * difference;
    }
  result.noise = std::sqrt(squares / static_cast<double>(letters_.size() + beside_.size()));
  for (size_t v = 0; v < noisy_edited.size(); ++v)
    result.largest_move =
        std::max(result.largest_move, (noisy_edited[v] - noisy_.vertices[v]).norm());
  return result;
}

}  // namespace burnish

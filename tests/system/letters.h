#pragma once

#include <cstdint>
#include <vector>

#include "common/generate/generate.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// How well the inscription of a tablet can be told from the noise. Units: of the tablet.
struct LetterContrast {
  double contrast = 0;      ///< how much lower the middles of strokes lie than the stone beside
  double noise = 0;         ///< deviation of what is left of the scanner's noise
  double largest_move = 0;  ///< of any vertex
  double ratio() const { return contrast / noise; }
};

/// A generated tablet as scanned, and the same stone with the scanner's noise the other way.
class NoisyTablet {
 public:
  /// `noise`: its deviation over the mean edge. Another seed: another stone and other noise.
  NoisyTablet(uint64_t vertices, double noise, NoiseKind kind = NoiseKind::kRange,
              uint64_t seed = 1);

  const TriangleMesh& noisy() const { return noisy_; }
  const TriangleMesh& mirrored() const { return mirrored_; }

  /// Measures what a filter made of both. Noise is half of what they differ by, along the face's
  /// normal: a filter that follows the noise is the same one for both.
  LetterContrast contrast(const std::vector<Vec3d>& noisy_edited,
                          const std::vector<Vec3d>& mirrored_edited) const;

 private:
  TriangleMesh noisy_, mirrored_;
  std::vector<uint32_t> letters_, beside_;  // vertices
};

}  // namespace burnish

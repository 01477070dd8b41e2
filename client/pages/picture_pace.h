#pragma once

#include <cstdint>

namespace burnish {

/// Learns how many triangles a picture may have while something moves, so that pictures follow each
/// other at ten a second where the card is slow.
class PicturePace {
 public:
  /// A picture of so many triangles took so long, from its begin until the card had drawn it.
  void on_picture(uint64_t triangles, double ms);

  /// Returns the most triangles of a moving picture; 0: any number, for the card is fast enough.
  uint64_t triangles_max() const { return triangles_max_; }

  static constexpr double kPictureMs = 100;
  static constexpr uint64_t kTrianglesMin = 5'000;  // with fewer the scan is not recognised

 private:
  uint64_t triangles_max_ = 0;
};

}  // namespace burnish

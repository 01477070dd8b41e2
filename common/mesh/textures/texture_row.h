#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "common/mesh/textures/texture_wrap.h"
#include "common/picture/picture_rows.h"

namespace burnish {

/// A row of a texture, linear between the centres of its pixels. Means along it cost the same for
/// any length. A value is red, green and blue in linear light, and which part of it is known: 1, or
/// less where a run has not all pixels. Values of several runs of one row add up to the whole
/// row's.
class TextureRow {
 public:
  static constexpr uint64_t kBytesPerColumn = sizeof(Eigen::Array4f) + sizeof(Eigen::Array4d);

  /// Needs: `width` > 0, in pixels.
  explicit TextureRow(uint32_t width);

  void set(const PixelRun& run);

  /// Returns the mean from `begin` to `end`, in pixels from the left border of the first one. Both
  /// may be beyond the borders, in any order, or equal.
  Eigen::Array4d mean(double begin, double end, TextureWrap wrap) const;

 private:
  Eigen::Array4d integral(double x, TextureWrap wrap) const;
  Eigen::Array4d integral_inside(double x, TextureWrap wrap) const;
  Eigen::Array4d integral_from_first(double x, TextureWrap wrap) const;
  const Eigen::Array4f& beyond(bool is_right, TextureWrap wrap) const;

  std::vector<Eigen::Array4f> pixels_;
  std::vector<Eigen::Array4d> sums_;  // from the first pixel's centre to each one's
};

}  // namespace burnish

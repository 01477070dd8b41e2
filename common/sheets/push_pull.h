#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace burnish {

/// Red, green, blue and alpha, 0..255, as a screen takes them (sRGB).
using Texel = Eigen::Vector4f;

/// Texels of which some are known. Row by row.
struct TexelGrid {
  TexelGrid(int columns, int rows)
      : width(columns),
        height(rows),
        texels(size_t(columns) * rows, Texel::Zero()),
        is_known(size_t(columns) * rows, 0) {}

  size_t at(int x, int y) const { return size_t(y) * width + x; }

  int width;
  int height;
  std::vector<Texel> texels;
  std::vector<uint8_t> is_known;
};

/// Makes all texels known: means of known ones, halved again and again, flow back to where nothing
/// is known (Gortler et al., "The Lumigraph", 1996). Leaves a grid in which nothing is known.
void push_pull(TexelGrid& grid);

}  // namespace burnish

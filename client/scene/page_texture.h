#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "common/base/types.h"

namespace burnish {

/// Maps a position in PageSpace, before any displacement, to texels of the finest level: the place
/// is u · (position, 1) and v · (position, 1). Texel i has its centre at i + 1/2.
struct TextureChart {
  Eigen::Vector4f u;
  Eigen::Vector4f v;
};

/// A texture at one density.
struct TextureLevel {
  int width = 0;
  int height = 0;
  std::vector<Rgba8> texels;  ///< sRGB, row by row; drawn opaque
};

/// Each level has half the density of the one before. The gutters of sheets carry so many.
inline constexpr size_t kTextureLevels = 3;

/// The texture of a page, which replaces its vertices' colours in Colouring::kScan.
struct PageTexture {
  std::vector<uint16_t> chart_of_triangle;  ///< one per triangle of the page; a number of a chart
  std::vector<uint32_t> patch_ends;         ///< of each patch of the page: triangles up to its end
  std::vector<TextureChart> charts;
  std::array<TextureLevel, kTextureLevels> levels;

  size_t bytes() const;
};

/// Returns a texture's levels: means of 2x2 texels. A last column or row alone counts twice.
/// Needs: width * height texels.
std::array<TextureLevel, kTextureLevels> texture_levels(int width, int height,
                                                        std::vector<Rgba8> texels);

}  // namespace burnish

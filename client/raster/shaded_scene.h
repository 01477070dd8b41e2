#pragma once

#include <array>
#include <span>
#include <vector>

#include "client/raster/page_projection.h"
#include "client/raster/raster_page.h"
#include "client/raster/shade_batch.h"
#include "client/scene/draw_style.h"

namespace burnish {

/// A ring of DrawStyle in PageSpace.
struct ShadedRing {
  ShadeVector centre;
  float radius;
  ShadeVector colour;  // linear
};

/// All that a pixel's colour depends on besides its triangle.
struct ShadedScene {
  std::span<const RasterPage> pages;  ///< by slot
  PageProjection projection;
  LightTerms light;
  Colouring colouring = Colouring::kClay;
  float displacement_low = 1, displacement_high = 1;
  ShadeVector base;  ///< of the light's kind, linear
  ShadeVector tint;  ///< linear
  std::vector<ShadedRing> rings;
  bool flat = false;
  bool wireframe = false;
  int first_moved_column = 0;  ///< columns before it show the original

  bool shows_original(int column) const { return column < first_moved_column; }
};

ShadedScene make_shaded_scene(std::span<const RasterPage> pages, const PageSpace& space,
                              const PageProjection& projection, const DrawStyle& style);

}  // namespace burnish

#pragma once

#include "client/raster/g_buffer.h"
#include "client/raster/shaded_scene.h"
#include "client/raster/visibility.h"
#include "client/scene/image.h"

namespace burnish {

/// Rows first..end-1 of a picture, from above.
struct RowRange {
  int first = 0;
  int end = 0;
};

/// Colours rows: what the samples show, in front of the background, averaged. Needs: `image` has
/// its size.
void shade_rows(const ShadedScene& scene, const Visibility& visibility, const RowRange& rows,
                Image& image);

/// Likewise, but keeps every sample. Needs: room for all samples.
void shade_g_buffer(const ShadedScene& scene, const Visibility& visibility, const RowRange& rows,
                    GBuffer& g_buffer);

}  // namespace burnish

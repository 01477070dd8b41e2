#pragma once

#include <cstdint>
#include <vector>

#include "client/raster/g_buffer_place.h"
#include "client/raster/shade_rows.h"

namespace burnish {

/// Ambient occlusion of each pixel, times 255, in rows from above.
using Occlusions = std::vector<uint8_t>;

/// Fills rows with ambient occlusion, as the shader in client/gl/occlusion_shader.cpp does.
void occlude_rows(const GBufferPlaces& places, const RowRange& rows, Occlusions& occlusions);

}  // namespace burnish

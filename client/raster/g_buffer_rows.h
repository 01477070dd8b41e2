#pragma once

#include "client/raster/occlusion_rows.h"

namespace burnish {

/// Averages the samples of rows, each with the light of its surroundings, as the shader in
/// client/gl/g_buffer_shader.cpp does. `occlusions` counts where lighting.occlusion > 0.
void light_g_buffer(const GBufferPlaces& places, const GBuffer& g_buffer,
                    const Occlusions& occlusions, const Lighting& lighting, const RowRange& rows,
                    Image& image);

}  // namespace burnish

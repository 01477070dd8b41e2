#pragma once

#include "client/raster/occlusion_rows.h"

namespace burnish {

/// Averages the samples of rows, each with the light of its surroundings, as the shader in
/// client/gl/relief_shader.cpp does. `occlusions` counts where lighting.occlusion > 0.
void light_reliefs(const ReliefPlaces& places, const SampleReliefs& reliefs,
                   const Occlusions& occlusions, const Lighting& lighting, const RowRange& rows,
                   Image& image);

}  // namespace burnish

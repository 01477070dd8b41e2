#pragma once

#include <string>

#include "common/base/record.h"
#include "common/base/status.h"

namespace burnish {

inline constexpr double kTextureGainMax = 4;

/// Says what becomes of a scan's colours beside their filter: how much they differ from what the
/// grid knows of them, texels too, and how much of the light in them goes. It works in linear
/// light, and solves nothing. Levelled seams change exported pictures and sheets, and no vertex's
/// colour (common/mesh/rewrite/pictures/level_seams.h).
struct TextureFilter {
  double gain = 1;          ///< 0 to kTextureGainMax; 1 keeps the details
  double remove_light = 0;  ///< 0 to 1; 0 keeps the light
  double level_seams = 0;   ///< 0 to 1: of the steps between charts of pictures; 0 keeps them
  bool operator==(const TextureFilter&) const = default;

  bool is_on() const { return *this != TextureFilter(); }
  /// Returns whether it changes more than the seams.
  bool changes_colours() const { return gain != 1 || remove_light != 0; }
};
BURNISH_RECORD(TextureFilter, gain, remove_light, level_seams)

/// Describes it in a few words: "texture gain 2, light removed by 0.5, seams levelled by 1",
/// without what is kept of the seams.
std::string text_of(const TextureFilter& filter);

/// Fails: invalid_argument that names the value and its limits.
Status check_texture_filter(const TextureFilter& filter);

}  // namespace burnish

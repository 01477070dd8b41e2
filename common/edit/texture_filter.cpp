#include "common/edit/texture_filter.h"

#include <cstdio>

#include "common/edit/check_between.h"

namespace burnish {

std::string text_of(const TextureFilter& filter) {
  char text[160];
  const int size = std::snprintf(text, sizeof text, "texture gain %g, light removed by %g",
                                 filter.gain, filter.remove_light);
  if (filter.level_seams != 0)
    std::snprintf(text + size, sizeof text - size, ", seams levelled by %g", filter.level_seams);
  return text;
}

Status check_texture_filter(const TextureFilter& filter) {
  RETURN_IF_ERROR(check_between("texture: gain", filter.gain, 0, kTextureGainMax));
  RETURN_IF_ERROR(check_between("texture: removed light", filter.remove_light, 0, 1));
  return check_between("texture: levelled seams", filter.level_seams, 0, 1);
}

}  // namespace burnish

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/pictures/picture.h"
#include "common/base/status.h"
#include "common/mesh/io/textured_surface.h"

namespace burnish {

/// A picture of a scan with the texels of its pictures.
struct TexturedPicture {
  std::optional<Image> image;         ///< nothing: none of the scan's pictures has texels
  std::vector<std::string> warnings;  ///< what it shows not at all, or not as sharp as it should
};

/// Draws a scan, without a window, with LoneRenderer. The scan's pictures are decoded into files
/// without names in the folder for temporary files. `name` is for messages. Needs: the textures fit
/// the mesh. Fails: invalid_argument (size); resource_exhausted; a damaged picture if the textures
/// refuse damage; as bake_view_textures().
Result<TexturedPicture> draw_textured_picture(const TexturedSurface& surface,
                                              const std::string& name,
                                              const PictureOptions& options);

}  // namespace burnish

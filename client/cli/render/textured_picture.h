#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/pictures/picture.h"
#include "common/base/status.h"
#include "common/mesh/io/textured_surface.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

/// A picture of a scan with the texels of its pictures.
struct TexturedPicture {
  std::optional<Image> image;         ///< nothing: none of the scan's pictures has texels
  std::vector<std::string> warnings;  ///< what it shows not at all, or not as sharp as it should
};

/// Draws a scan, without a window, with LoneRenderer. The scan's pictures are decoded into files
/// without names in temporary_folder(). The budget admits the decoding, and a quarter of its memory
/// limits the textures. `name` is for messages. Needs: the textures fit the mesh. Fails:
/// invalid_argument (size); resource_exhausted; a damaged picture if the textures refuse damage; as
/// temporary_folder() and bake_view_textures().
Result<TexturedPicture> draw_textured_picture(const TexturedSurface& surface,
                                              const std::string& name,
                                              const PictureOptions& options,
                                              PreparationBudget& budget);

}  // namespace burnish

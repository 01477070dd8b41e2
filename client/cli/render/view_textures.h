#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "client/scene/camera.h"
#include "client/scene/image.h"
#include "client/scene/page_texture.h"
#include "client/scene/raw_pages.h"
#include "common/base/status.h"
#include "common/mesh/io/textured_surface.h"
#include "server/prepare/sheets/picture_tiles.h"

namespace burnish {

/// The one picture for which textures are made.
struct ViewWish {
  Camera camera;
  ImageSize size;          ///< pixels
  uint64_t bytes_max = 0;  ///< of all textures in memory
};

/// The pages of a scan with the textures that a picture shows.
struct ViewTextures {
  RawPages raw;
  /// One for each page; null: the page lies outside the picture.
  std::vector<std::shared_ptr<const PageTexture>> of_page;
  int halvings = 0;  ///< so often the textures have half the density that the picture needs
};

/// Cuts a scan into raw pages, and bakes a sheet for each from the scan's pictures: as dense as a
/// session's picture at rest needs it, or as the pictures are where they have less. Where all would
/// exceed `bytes_max`, all are halved alike. Needs: a valid mesh; textures that fit it; tiles of
/// their pictures. Fails: as make_painted_sheets(). The same input gives the same bytes for any
/// number of threads.
Result<ViewTextures> bake_view_textures(const TexturedSurface& surface, const PictureTiles& tiles,
                                        const ViewWish& wish);

}  // namespace burnish

#include "client/cli/render/textured_picture.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <new>

#include "client/cli/render/view_textures.h"
#include "client/pictures/lone_renderer.h"
#include "common/base/scratch_file.h"
#include "server/prepare/sheets/decode_pictures.h"
#include "server/prepare/sheets/sheets_need.h"

namespace burnish {

// Limits of the textures of a picture. Most of the memory is for the surface, and for what baking
// and drawing take.
static constexpr uint64_t kPictureTextureBytesMax = 2'000'000'000;  // a card has one of its own
static constexpr uint64_t kPartsOfMemory = 4;                       // textures may take one

static uint64_t texture_bytes_max(const LoneRenderer& renderer, const PreparationBudget& budget) {
  const uint64_t drawn =
      renderer.has_card() ? renderer->texture_bytes_max() : kPictureTextureBytesMax;
  return std::min(drawn, budget.memory_bytes_max() / kPartsOfMemory);
}

static Result<DecodedPictures> decode(const TexturedSurface& surface, const std::string& name,
                                      PreparationBudget& budget) {
  ASSIGN_OR_RETURN(const std::filesystem::path folder, temporary_folder());
  SheetsNeed need(surface.mesh, {}, budget);
  RETURN_IF_ERROR(need.ask_for_pages(0));
  const auto admit = [&](uint64_t memory, uint64_t scratch) {
    return need.ask_for_picture(memory, scratch);
  };
  return decode_pictures(surface.textures, name, folder, admit, {});
}

static void warn_of_pictures(const DecodedPictures& pictures, TexturedPicture& drawn) {
  if (pictures.left_out.empty()) return;
  const size_t count = pictures.left_out.size();
  drawn.warnings.push_back(
      (count == 1 ? "a picture is not shown, or not whole: "
                  : std::to_string(count) + " pictures are not shown, or not whole: ") +
      pictures.left_out.front().message());
}

static void warn_of_halvings(const ViewTextures& textures, uint64_t bytes_max,
                             TexturedPicture& drawn) {
  if (textures.halvings == 0) return;
  drawn.warnings.push_back("the textures are " + std::to_string(1 << textures.halvings) +
                           " times coarser than the picture needs: their limit is " +
                           std::to_string(bytes_max / 1'000'000) + " MB");
}

Result<TexturedPicture> draw_textured_picture(const TexturedSurface& surface,
                                              const std::string& name,
                                              const PictureOptions& options,
                                              PreparationBudget& budget) try {
  RETURN_IF_ERROR(check_image_size(options.size));
  ASSIGN_OR_RETURN(const DecodedPictures pictures, decode(surface, name, budget));
  TexturedPicture drawn;
  warn_of_pictures(pictures, drawn);
  if (pictures.count == 0) return drawn;
  const LoneRenderer renderer;
  const uint64_t bytes_max = texture_bytes_max(renderer, budget);
  const Camera camera = picture_camera(options, referenced_box(surface.mesh));
  ASSIGN_OR_RETURN(const ViewTextures textures,
                   bake_view_textures(surface, pictures.tiles, {camera, options.size, bytes_max}));
  warn_of_halvings(textures, bytes_max, drawn);
  PictureOptions coloured = options;
  coloured.style.colouring = Colouring::kScan;
  ASSIGN_OR_RETURN(drawn.image, draw_picture(textures.raw, textures.of_page, coloured, *renderer));
  return drawn;
} catch (const std::bad_alloc&) {
  return resource_exhausted(name + ": not enough memory for its textures");
}

}  // namespace burnish

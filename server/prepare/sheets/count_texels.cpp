#include "server/prepare/sheets/count_texels.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "common/base/heard_loop.h"
#include "common/mesh/textures/shown_picture.h"
#include "common/picture/picture_rows.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

static constexpr double kTexelsPerPage = 512 * 512;  // charts cover about half of a sheet
static constexpr double kPagesForTexelsMax = 1024;   // 2^28 texels and more: minutes
static constexpr double kRepeatsMax = 16;            // of all pictures, that deserve pages
static constexpr double kSheetTexelsMax = double{kSheetSideMax} * kSheetSideMax;

/// `own_texels`: of all pictures.
static double texels_of_page_max(std::span<const float> texels, double own_texels) {
  const double sum = std::accumulate(texels.begin(), texels.end(), 0.0);
  const double pages_max =
      std::clamp(kRepeatsMax * own_texels / kTexelsPerPage, 1.0, kPagesForTexelsMax);
  return std::max(kTexelsPerPage, sum / pages_max);
}

static Result<double> read_texels(const SurfacePicture& picture, const std::string& name) {
  ASSIGN_OR_RETURN(const std::vector<uint8_t> file, picture.read());
  ASSIGN_OR_RETURN(const PictureSize size, read_picture_size(file, name + ": " + picture.name));
  return static_cast<double>(size.width) * size.height;
}

static bool ends_counting(const Status& status) {
  return status.code() == StatusCode::kCancelled || status.code() == StatusCode::kResourceExhausted;
}

/// Returns the texels of each picture.
static Result<std::vector<double>> texels_of_pictures(const SurfaceTextures& textures,
                                                      const std::string& name,
                                                      const Progress& progress) {
  std::vector<double> texels(textures.pictures.size());
  const size_t count = std::min(texels.size(), kTexturePicturesMax);
  for (size_t picture = 0; picture < count; ++picture) {
    if (!report(progress, "reading", 0)) return cancelled("reading pictures was cancelled");
    const auto read = read_texels(textures.pictures[picture], name);
    if (ends_counting(read.status())) return read.status();
    if (read.is_ok()) texels[picture] = *read;
  }
  return texels;
}

Result<CountedTexels> count_texels(const SurfaceTextures& textures, const std::string& name,
                                   const ScratchSpace& space, const Progress& progress) try {
  ASSIGN_OR_RETURN(const std::vector<double> of_picture,
                   texels_of_pictures(textures, name, progress));
  if (std::ranges::all_of(of_picture, [](double texels) { return texels == 0; }))
    return CountedTexels();
  ScratchArray<float> texels(space, textures.triangles.size());
  parallel_for_heard({progress, "reading", 0, 0}, texels.size(), [&](size_t t) {
    const auto triangle = static_cast<uint32_t>(t);
    const uint32_t picture = shown_picture(textures, triangle);
    if (picture != kNoTexture)
      texels[t] = static_cast<float>(
          std::min(area_on_picture(textures, triangle) * of_picture[picture], kSheetTexelsMax));
  });
  const double of_page_max = texels_of_page_max(
      {texels.data(), texels.size()}, std::accumulate(of_picture.begin(), of_picture.end(), 0.0));
  return CountedTexels{std::move(texels), of_page_max};
} catch (const WorkCancelled&) {
  return cancelled("counting texels was cancelled");
}

}  // namespace burnish

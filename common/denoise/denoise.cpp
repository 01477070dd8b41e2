#include "common/denoise/denoise.h"

#include "common/denoise/normal_filter.h"
#include "common/denoise/normal_layer.h"

namespace burnish {
namespace {

/// Returns the value that `work` makes, or why it made none.
template <typename Work>
auto unless_left(const Work& work) -> Result<decltype(work())> {
  try {
    return work();
  } catch (const WorkCancelled&) {
    return cancelled("denoising was cancelled");
  } catch (const std::bad_alloc& failure) {
    return resource_exhausted(std::string("denoising has no memory: ") + failure.what());
  }
}

std::vector<Vec3f> filtered_layer(const DenoiseSurface& surface, const DenoiseOptions& options,
                                  const ScratchSpace& space, const Progress& progress,
                                  const PassShown& shown) {
  const LoopPart normals = {progress, "normals"}, layer = {progress, "layer"};
  NormalFilter filter(surface.welded, surface.rings, options.kind, options.sigma, space,
                      normals.of(0, 0.1));
  for (int pass = 0; pass < options.passes; ++pass) {
    const double done = static_cast<double>(pass) / options.passes;
    const double then = static_cast<double>(pass + 1) / options.passes;
    filter.pass(normals.of(0.1 + 0.9 * done, 0.1 + 0.9 * then));
    if (shown) shown(pass + 1, filter.normals());
  }
  return normal_layer(surface.welded, filter.normals(), {.cap = options.cap}, space, layer);
}

}  // namespace

Result<std::shared_ptr<const DenoiseSurface>> make_denoise_surface(const MeshView& mesh,
                                                                   const ScratchSpace& space,
                                                                   const Progress& progress) {
  const LoopPart part = {progress, "rings"};
  return unless_left([&]() -> std::shared_ptr<const DenoiseSurface> {
    return std::make_shared<DenoiseSurface>(mesh, space, part);
  });
}

Result<std::vector<Vec3f>> denoise_layer(const DenoiseSurface& surface,
                                         const DenoiseOptions& options, const ScratchSpace& space,
                                         const Progress& progress, const PassShown& shown) {
  RETURN_IF_ERROR(validate(options));
  return unless_left([&] { return filtered_layer(surface, options, space, progress, shown); });
}

}  // namespace burnish

#include "common/denoise/denoise.h"

#include "common/denoise/heard_blocks.h"
#include "common/denoise/normal_filter.h"
#include "common/denoise/normal_layer.h"
#include "common/denoise/unless_left.h"

namespace burnish {
namespace {

std::vector<Vec3f> filtered_layer(const DenoiseSurface& surface, const EdgeFilter& wanted,
                                  const ScratchSpace& space, const Progress& progress,
                                  const PassShown& shown) {
  const LoopPart normals = {progress, "normals"}, layer = {progress, "layer"};
  NormalFilter filter(surface.welded, surface.rings, wanted.kind, wanted.sigma(), space,
                      normals.of(0, 0.1));
  for (int pass = 0; pass < wanted.passes; ++pass) {
    filter.pass(part_of_pass(normals.of(0.1, 1), pass, wanted.passes));
    if (shown) shown(pass + 1, filter.normals());
  }
  return normal_layer(surface.welded, filter.normals(), {}, space, layer);
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

Result<std::vector<Vec3f>> denoise_layer(const DenoiseSurface& surface, const EdgeFilter& wanted,
                                         const ScratchSpace& space, const Progress& progress,
                                         const PassShown& shown) {
  RETURN_IF_ERROR(check_edge_filter(wanted));
  return unless_left([&] { return filtered_layer(surface, wanted, space, progress, shown); });
}

}  // namespace burnish

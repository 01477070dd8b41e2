#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/denoise/triangle_normals.h"
#include "common/denoise/triangle_rings.h"
#include "common/denoise/welded_surface.h"
#include "common/edit/edge_filter.h"

namespace burnish {

/// The parts of a mesh that the filters need. They depend on no option.
struct DenoiseSurface {
  /// Needs: a valid mesh, whose arrays outlive this. Throws: WorkCancelled, std::bad_alloc.
  explicit DenoiseSurface(const MeshView& mesh, const ScratchSpace& space = {},
                          const LoopPart& part = kUnheardLoop)
      : welded(mesh, space, part.of(0, 0.5)), rings(welded, space, part.of(0.5, 1)) {}

  WeldedSurface welded;
  TriangleRings rings;
};

/// Called after each pass with its number from 1 on and the normals so far, one per triangle of the
/// mesh; normal_layer() makes their layer. Comes from the thread that called denoise_layer().
using PassShown = std::function<void(int pass, std::span<const NormalAndArea> normals)>;

/// Needs: a valid mesh, whose arrays outlive the result. Cost: about 90 bytes a triangle to keep,
/// in `space`. Fails: cancelled; resource_exhausted without memory.
Result<std::shared_ptr<const DenoiseSurface>> make_denoise_surface(const MeshView& mesh,
                                                                   const ScratchSpace& space = {},
                                                                   const Progress& progress = {});

/// Returns the layer of a denoising that keeps edges: one move w per vertex of the mesh, file
/// units. Strength and crispness are not in it: a vertex goes to x + strength crispness w. The same
/// bits for any number of threads. Fails: invalid_argument as check_edge_filter() does; cancelled;
/// resource_exhausted without memory.
Result<std::vector<Vec3f>> denoise_layer(const DenoiseSurface& surface, const EdgeFilter& wanted,
                                         const ScratchSpace& space = {},
                                         const Progress& progress = {},
                                         const PassShown& shown = {});

}  // namespace burnish

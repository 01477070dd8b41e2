#include "server/session/edge_parts.h"

#include <utility>

#include "common/base/out_of_memory.h"
#include "server/fields/target_fit.h"
#include "server/solver/surface_filters.h"

namespace burnish {
namespace {

constexpr uint64_t kSurfaceBytesPerTriangle = 90;
// The filter and the layer at work: weights of pairs, two fields of normals, guides, updates.
constexpr uint64_t kWorkBytesPerTriangle = 165, kWorkBytesPerVertex = 28;
// The fit needs pieces of triangles after the filter has ended: no more than its work and this.
constexpr uint64_t kPieceBytesPerCell = 48;
// The strength at a vertex, and in a cell for the session and for the solver.
constexpr uint64_t kStrengthBytes = sizeof(float);
// Beside the layers of two filters: places, shares and moves of what is shown, which vertices pages
// have, and where the scan's are.
constexpr uint64_t kShownBytesPerTriangle = sizeof(uint8_t);  // whether it has turned
constexpr uint64_t kShownBytesPerVertex = sizeof(Vec3d) + sizeof(Vec3f) + 6 * sizeof(uint32_t);

Result<std::shared_ptr<const DenoiseSurface>> surface_of(const PreparedMesh& prepared,
                                                         const Progress& progress) {
  MeshView mesh;
  mesh.vertices = prepared.vertices;
  mesh.triangles = prepared.triangles;
  return make_denoise_surface(mesh, {}, progress);
}

Result<std::shared_ptr<const EdgeParts>> make_parts(const PreparedMesh& prepared,
                                                    BackendKind backend, const EdgeFilter& filter,
                                                    const EdgeParts* before,
                                                    const Progress& progress) {
  auto parts = std::make_shared<EdgeParts>();
  parts->filter = filter;
  if (before) {
    parts->surface = before->surface;
    parts->on = before->on;
  } else {
    ASSIGN_OR_RETURN(parts->surface, surface_of(prepared, progress));
    ASSIGN_OR_RETURN(parts->on, make_surface_filter(backend, parts->surface));
  }
  if (before && has_same_normals(filter, before->filter)) {
    parts->filtered = before->filtered;
  } else {
    ASSIGN_OR_RETURN(FilteredSurface filtered, parts->on->filter(filter, progress));
    parts->filtered = std::make_shared<const FilteredSurface>(std::move(filtered));
  }
  const SurfaceTarget target = {parts->filtered->normals, parts->filtered->layer, filter.crispness};
  ASSIGN_OR_RETURN(parts->target, fit_target(prepared, target, progress));
  return std::shared_ptr<const EdgeParts>(std::move(parts));
}

}  // namespace

bool has_same_normals(const EdgeFilter& a, const EdgeFilter& b) {
  return a.kind == b.kind && a.edge_angle == b.edge_angle && a.passes == b.passes;
}

Result<std::shared_ptr<const EdgeParts>> make_edge_parts(
    const PreparedMesh& prepared, BackendKind backend, const EdgeFilter& filter,
    const std::shared_ptr<const EdgeParts>& before, const Progress& progress) {
  return with_memory_for("keeping edges", [&] {
    return make_parts(prepared, backend, filter, before.get(), progress);
  });
}

uint64_t EdgeParts::byte_count() const {
  return kSurfaceBytesPerTriangle * surface->welded.triangle_count() + on->byte_count() +
         (filtered->normals.size() + filtered->layer.size()) * sizeof(Vec3f) +
         target.size() * sizeof(TargetGradient);
}

uint64_t predict_edge_bytes(const Multigrid& on) {
  const PreparedMesh& scan = *on.prepared;
  constexpr uint64_t kFilters = 2;  // one is made while the other is shown
  const uint64_t per_triangle = kSurfaceBytesPerTriangle + kWorkBytesPerTriangle +
                                kShownBytesPerTriangle + kFilters * sizeof(Vec3f);
  const uint64_t per_vertex =
      kWorkBytesPerVertex + kShownBytesPerVertex + kStrengthBytes + kFilters * sizeof(Vec3f);
  const uint64_t per_cell =
      kFilters * sizeof(TargetGradient) + 2 * kStrengthBytes + kPieceBytesPerCell;
  return scan.triangles.size() * per_triangle + scan.vertices.size() * per_vertex +
         scan.cells.size() * per_cell;
}

}  // namespace burnish

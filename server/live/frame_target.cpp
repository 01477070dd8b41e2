#include "server/live/frame_target.h"

#include "common/base/out_of_memory.h"
#include "common/evaluation/proxy.h"
#include "server/memory/memory_need.h"
#include "server/scheduling/cancellable_lock.h"

namespace burnish {

FrameMesh FrameTarget::frame_mesh() const {
  const Hierarchy& hierarchy = *mesh->hierarchy;
  const SparseGrid& grid = hierarchy.at(hierarchy.finest).grid;
  if (proxy_points.empty()) return {grid, mesh->prepared->evaluation};
  return {grid, proxy_points};
}

static FrameLayout make_layout(const FrameMesh& mesh, std::optional<FrameContent> content) {
  if (!content) return make_smaller_layout(mesh);
  return *content == FrameContent::kVertices ? make_vertex_layout(mesh)
                                             : make_coefficient_layout(mesh);
}

Result<std::shared_ptr<const FrameTarget>> FrameTargets::find_or_make(
    const std::shared_ptr<const SharedMesh>& mesh, uint64_t triangles_max,
    std::optional<FrameContent> content, const Progress& progress) {
  const PreparedMesh& prepared = *mesh->prepared;
  triangles_max = rounded_triangles_max(triangles_max);  // rounded as for the view
  if (triangles_max >= prepared.triangles.size()) triangles_max = 0;
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(mutex_, "waiting for another client's frames", progress));
  std::erase_if(targets_, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<const FrameTarget>& known = targets_[{mesh.get(), triangles_max, content}];
  if (auto target = known.lock()) return target;

  if (!report(progress, "laying out frames", 0)) return cancelled("cancelled before any frame");
  auto target = std::make_shared<FrameTarget>();
  target->mesh = mesh;
  ASSIGN_OR_RETURN(
      target->memory,
      memory_.take(kServer, predict_target_bytes(prepared, *mesh->hierarchy, triangles_max)));
  RETURN_IF_ERROR(with_memory_for("laying out frames", [&]() -> Status {
    if (triangles_max > 0) {
      ASSIGN_OR_RETURN(const auto meanwhile, memory_.take(kServer, predict_proxy_bytes(prepared)));
      target->proxy_points =
          make_proxy({prepared.vertices, prepared.triangles, prepared.evaluation}, triangles_max)
              .evaluation;
    }
    target->layout =
        std::make_shared<const FrameLayout>(make_layout(target->frame_mesh(), content));
    return Status::ok();
  }));
  known = target;
  return std::shared_ptr<const FrameTarget>(std::move(target));
}

}  // namespace burnish

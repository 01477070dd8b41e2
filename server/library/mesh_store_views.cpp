// The part of MeshStore for clients that draw.

#include "common/base/out_of_memory.h"
#include "common/evaluation/proxy.h"
#include "server/library/mesh_store.h"
#include "server/scheduling/cancellable_lock.h"

namespace burnish {

// Bytes while a view is made: its parts, their planes and the packed bytes; for a proxy the indices
// and float positions instead.
static uint64_t predict_view_bytes(const PreparedMesh& prepared) {
  return prepared.vertices.size() * 64 + prepared.triangles.size() * 40 +
         prepared.cells.size() * 24;
}

static ViewSource source_of(const PreparedMesh& prepared) {
  return {.frame = prepared.frame,
          .length_unit = prepared.length_unit,
          .cells = prepared.cells,
          .mesh = {prepared.vertices, prepared.triangles, prepared.evaluation},
          .colours = prepared.colours};
}

namespace {

/// A view with its share of the server's memory; the last holder gives the share back.
struct ChargedView {
  PackedView view;
  Quota::Share memory;
};

}  // namespace

Result<std::shared_ptr<const PackedView>> MeshStore::open_view(const std::string& id,
                                                               const PreparedKey& key,
                                                               uint64_t triangles_max,
                                                               const Progress& progress) {
  const ViewCache::Key wanted{id, key, rounded_triangles_max(triangles_max)};
  if (auto kept = views_.find(wanted)) return kept;
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(making_view_, "waiting for another view", progress));
  if (auto kept = views_.find(wanted)) return kept;
  if (!report(progress, "making the view", 0)) return cancelled("the view was cancelled");
  ASSIGN_OR_RETURN(const auto mesh, find_prepared(id, key));
  const auto made = std::make_shared<ChargedView>();
  ASSIGN_OR_RETURN(made->memory, memory_.take(kServer, predict_view_bytes(*mesh->prepared)));
  RETURN_IF_ERROR(with_memory_for("the view of scan " + short_id(id), [&] {
    made->view = make_view(source_of(*mesh->prepared), wanted.triangles_max);
    return Status::ok();
  }));
  RETURN_IF_ERROR(made->memory.resize(made->view.bytes.capacity()));
  const std::shared_ptr<const PackedView> view(made, &made->view);
  views_.add(wanted, view);
  return view;
}

Result<std::shared_ptr<const SharedMesh>> MeshStore::find_prepared(const std::string& id,
                                                                   const PreparedKey& key) {
  if (auto shared = cache_.find({id, key})) return shared;
  auto read = read_charged(id, key, Charged::kMeshAlone);
  if (read.status().code() == StatusCode::kNotFound)
    return failed_precondition("scan " + short_id(id) + " is not prepared at depth " +
                               std::to_string(key.depth) + "; open a session or prepare it first");
  RETURN_IF_ERROR(read.status());
  return std::shared_ptr<const SharedMesh>(std::move(read).value());
}

}  // namespace burnish

// What MeshStore does for clients that draw.

#include "server/session/cancellable_lock.h"
#include "server/session/mesh_store.h"
#include "server/session/scan_record.h"

namespace burnish {

// While a view is made: its parts, their planes and the packed bytes; for a proxy the indices and
// float positions instead.
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

Result<std::shared_ptr<const PackedView>> MeshStore::open_view(const std::string& id,
                                                               const PreparedKey& key,
                                                               uint64_t triangles_max,
                                                               const Progress& progress) {
  const ViewCache::Key wanted{id, key, triangles_max};
  if (auto kept = views_.find(wanted)) return kept;
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(making_view_, "waiting for another view", progress));
  if (auto kept = views_.find(wanted)) return kept;
  if (!report(progress, "making the view", 0)) return cancelled("the view was cancelled");
  ASSIGN_OR_RETURN(const auto prepared, find_prepared(id, key));
  ASSIGN_OR_RETURN(const auto memory, memory_.take(kServer, predict_view_bytes(*prepared)));
  auto view = std::make_shared<const PackedView>(make_view(source_of(*prepared), triangles_max));
  views_.add(wanted, view);
  return view;
}

Result<std::shared_ptr<const PreparedMesh>> MeshStore::find_prepared(const std::string& id,
                                                                     const PreparedKey& key) {
  if (const auto shared = cache_.find({id, key})) return shared->prepared;
  auto mapped = map_prepared_mesh(scan_folder(id) / "prepared" / prepared_file_name(key));
  if (mapped.status().code() == StatusCode::kNotFound)
    return failed_precondition("scan " + short_id(id) + " is not prepared at depth " +
                               std::to_string(key.depth) + "; open a session or prepare it first");
  return mapped;
}

}  // namespace burnish

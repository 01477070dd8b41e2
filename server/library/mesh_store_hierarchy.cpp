// The part of MeshStore that makes hierarchies, and keeps them beside their prepared meshes.

#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include "common/base/out_of_memory.h"
#include "server/library/mesh_store.h"
#include "server/library/scan_record.h"
#include "server/memory/library_budget.h"
#include "server/memory/memory_need.h"
#include "server/solver/kept/hierarchy_file.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {

namespace fs = std::filesystem;

fs::path MeshStore::hierarchy_path(const std::string& id, const PreparedKey& key) const {
  return scan_folder(id) / "prepared" / hierarchy_file_name(key);
}

Status MeshStore::read_kept_hierarchy(const std::string& id, const PreparedKey& key,
                                      SharedMesh& mesh, const Progress& progress) {
  ASSIGN_OR_RETURN(Multigrid kept, read_hierarchy(hierarchy_path(id, key), mesh.prepared,
                                                  mesh.fingerprint, progress));
  static_cast<Multigrid&>(mesh) = std::move(kept);
  mesh.is_kept = true;
  spdlog::info("scan {}: its hierarchy comes from a file", short_id(id));
  return Status::ok();
}

// Whatever keeps the file from being read, the hierarchy can be made.
Status MeshStore::find_hierarchy(const std::string& id, const PreparedKey& key, SharedMesh& mesh,
                                 const Progress& progress) {
  const Status read = read_kept_hierarchy(id, key, mesh, progress);
  if (read.is_ok() || read.code() == StatusCode::kCancelled) return read;
  if (read.code() != StatusCode::kNotFound)
    spdlog::warn("making a hierarchy again: {}", read.message());
  ASSIGN_OR_RETURN(mesh.hierarchy, make_hierarchy(*mesh.prepared, progress));
  return Status::ok();
}

Status MeshStore::plan(const std::string& id, SharedMesh& mesh, const Progress& progress) {
  mesh.plan = std::make_shared<CyclePlan>();
  Quota::Share trial;  // a session for the trials
  if (needs_trials(*mesh.hierarchy)) {
    ASSIGN_OR_RETURN(trial, memory_.take(kServer, predict_session_bytes(mesh)));
  }
  return with_memory_for("the cycle of scan " + short_id(id), [&]() -> Status {
    ASSIGN_OR_RETURN(mesh.plan, plan_cycle(mesh.prepared, mesh.hierarchy, progress));
    return Status::ok();
  });
}

// Ends when the last session closes: the mesh's memory is promised to others then.
Status MeshStore::write_kept_hierarchy(const std::string& id, const PreparedKey& key,
                                       const std::shared_ptr<const SharedMesh>& mesh) {
  const auto goes_on = [&](std::string_view, double) {
    return !is_ending_ && mesh.use_count() > 1;
  };
  const uint64_t bytes = hierarchy_file_bytes(*mesh);
  RETURN_IF_ERROR(check_disk_space(folder_.scans(), bytes));
  RETURN_IF_ERROR(write_hierarchy(*mesh, mesh->fingerprint, hierarchy_path(id, key), goes_on));
  spdlog::info("scan {}: its hierarchy is kept in a file of {} bytes", short_id(id), bytes);
  return read_again(id);
}

// An edit's threads go first: this one gets what they leave of the processors.
static void give_way_to_other_threads() {
  constexpr int kLowest = 19;
  (void)setpriority(PRIO_PROCESS, 0, kLowest);
}

std::future<void> MeshStore::keep_hierarchy(const std::string& id, const PreparedKey& key,
                                            std::shared_ptr<const SharedMesh> mesh) {
  const auto done = std::make_shared<std::promise<void>>();
  std::future<void> future = done->get_future();
  if (mesh->is_kept.exchange(true)) {
    done->set_value();
    return future;
  }
  keeping_.post([this, id, key, mesh = std::move(mesh), done]() mutable {
    give_way_to_other_threads();
    const Status kept = write_kept_hierarchy(id, key, mesh);
    if (kept.code() == StatusCode::kCancelled) mesh->is_kept = false;
    mesh.reset();
    if (!kept.is_ok() && kept.code() != StatusCode::kCancelled)
      spdlog::warn("scan {}: its hierarchy is not kept: {}", short_id(id), kept.message());
    done->set_value();
  });
  return future;
}

}  // namespace burnish

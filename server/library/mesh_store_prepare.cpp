// The part of MeshStore that brings a prepared mesh to disk, and to memory for sessions.

#include <algorithm>

#include <spdlog/spdlog.h>

#include "common/base/limits.h"
#include "common/base/out_of_memory.h"
#include "server/library/mesh_store.h"
#include "server/library/read_original.h"
#include "server/library/scan_files.h"
#include "server/library/scan_record.h"
#include "server/memory/library_budget.h"
#include "server/memory/opening_need.h"
#include "server/prepare/prepare.h"
#include "server/prepare/prepared_file.h"
#include "server/scheduling/cancellable_lock.h"
#include "server/solver/kept/hierarchy_file.h"

namespace burnish {

namespace fs = std::filesystem;

// A missing or damaged prepared file is made again; other failures stay.
static bool can_be_made_again(const Status& status) {
  return status.code() == StatusCode::kNotFound || status.code() == StatusCode::kDataLoss;
}

Result<OriginalFile> MeshStore::find_original(const std::string& id, const Progress& progress) {
  ASSIGN_OR_RETURN(const ScanInfo scan, find(id));
  RETURN_IF_ERROR(bring_here(id, progress));
  RETURN_IF_ERROR(check_or_fetch(scan, progress));
  return OriginalFile{scan_folder(id) / original_file_name(scan.format), scan.format, scan.name};
}

static constexpr uint64_t kSmallReadingBytes = uint64_t{128} << 20;  // some 300,000 vertices
static constexpr uint64_t kPreparingPerReading = 8;                  // bytes of memory

// Tells from what the reading takes: a small file may be a large scan in an archive.
bool MeshStore::is_prepared_in_a_moment(const fs::path& original, MeshFormat format) const {
  const auto bytes = reading_bytes_max(original, format);
  const uint64_t free = memory_.max() - std::min(memory_.max(), memory_.taken());
  return bytes.is_ok() && *bytes <= kSmallReadingBytes && *bytes * kPreparingPerReading <= free;
}

Result<PreparingLine::Turn> MeshStore::wait_to_prepare(const std::string& id,
                                                       const std::string& user,
                                                       const Progress& progress) {
  const fs::path folder = scan_folder(id);
  const auto scan = read_scan_folder(folder);
  const bool is_small =
      scan.is_ok() &&
      is_prepared_in_a_moment(folder / original_file_name(scan->format), scan->format);
  ASSIGN_OR_RETURN(auto turn, preparing_.wait({user, id, is_small}, progress));
  unfinished_bake_.forget_others(id);
  return turn;
}

Status MeshStore::prepare_scan(const std::string& id, const PreparedKey& key,
                               const Progress& progress, const std::string& user) {
  RETURN_IF_ERROR(bring_here(id, progress));
  if (read_prepared_summary(prepared_path(id, key)).is_ok()) return Status::ok();
  ASSIGN_OR_RETURN(auto turn, wait_to_prepare(id, user, progress));
  return make_prepared(id, key, turn.progress(progress));
}

Status MeshStore::make_prepared(const std::string& id, const PreparedKey& key,
                                const Progress& progress) {
  const Status status = read_prepared_summary(prepared_path(id, key)).status();
  if (status.is_ok() || !can_be_made_again(status)) return status;
  if (status.code() == StatusCode::kDataLoss) spdlog::warn("preparing again: {}", status.message());
  return rebuild(id, key, progress);
}

Status MeshStore::rebuild(const std::string& id, const PreparedKey& key, const Progress& progress) {
  const fs::path folder = scan_folder(id);
  ASSIGN_OR_RETURN(const ScanInfo scan, read_scan_folder(folder));
  if (!report(progress, "reading", 0)) return cancelled("preparing was cancelled");
  RETURN_IF_ERROR(check_or_fetch(scan, progress));
  LibraryBudget budget(memory_, folder_.scans(), options_.device_memory_bytes_max);
  RETURN_IF_ERROR(budget.ask_to_read(folder / original_file_name(scan.format), scan.format));
  ASSIGN_OR_RETURN(const auto mesh, read_original(folder / original_file_name(scan.format),
                                                  scan.format, scan.name, budget, progress));
  ASSIGN_OR_RETURN(const auto prepared, prepare(mesh->view(), mesh,
                                                {key.depth, key.curvature_radius, options_.threads,
                                                 &budget, budget.space()},
                                                progress));
  RETURN_IF_ERROR(make_room(id, key));
  RETURN_IF_ERROR(make_prepared_folder(folder));  // somebody may have deleted it
  RETURN_IF_ERROR(write_prepared_mesh(*prepared, prepared_path(id, key), progress));
  return read_again(id);
}

// Prepared files can always be made again. Beyond the limit the one opened longest ago is deleted.
// No session refers to a file that is made again.
Status MeshStore::make_room(const std::string& id, const PreparedKey& key) {
  ASSIGN_OR_RETURN(const ScanInfo scan, read_scan_folder(scan_folder(id)));
  std::vector<std::pair<fs::file_time_type, fs::path>> idle;
  size_t count = 0;
  for (const PreparedInfo& have : scan.prepared) {
    if (have.key == key) continue;
    ++count;
    std::error_code error;
    const fs::path path = prepared_path(id, have.key);
    const fs::file_time_type opened = fs::last_write_time(path, error);
    if (!error && !is_in_use(id, have.key)) idle.emplace_back(opened, path);
  }
  std::sort(idle.begin(), idle.end());
  for (const auto& [opened, path] : idle) {
    if (count < kPreparedPerScanMax) break;
    std::error_code error;
    if (!fs::remove(path, error)) continue;
    fs::remove(hierarchy_path(id, parse_prepared_file_name(path.filename()).value()), error);
    --count;
  }
  if (count < kPreparedPerScanMax) return Status::ok();
  return resource_exhausted("scan " + scan.name + " has " + std::to_string(count) +
                            " prepared meshes that sessions use; the limit is " +
                            std::to_string(kPreparedPerScanMax));
}

void MeshStore::set_wanted(IsWanted is_wanted) {
  const std::lock_guard lock(wanted_mutex_);
  is_wanted_ = std::move(is_wanted);
}

bool MeshStore::is_in_use(const std::string& id, const PreparedKey& key) {
  if (cache_.find({id, key})) return true;
  const std::lock_guard lock(wanted_mutex_);
  return is_wanted_ && is_wanted_(id, key);
}

// Large ones stay where they lie, if the file system has leases: no copy, and no room for one.
Status MeshStore::hold_or_copy(const fs::path& path, const PreparedSummary& summary,
                               SharedMesh& mesh) {
  PreparedPlace place = place_of_prepared(summary.byte_count);
  const auto charge = [&]() -> Status {
    ASSIGN_OR_RETURN(mesh.memory, memory_.take(kServer, predict_mesh_bytes(summary, place)));
    return Status::ok();
  };
  if (place == PreparedPlace::kFile) {
    RETURN_IF_ERROR(charge());
    auto held = hold_prepared_mesh(path, folder_.scans());
    if (held.is_ok()) mesh.prepared = std::move(held).value();
    if (held.status().code() != StatusCode::kFailedPrecondition) return held.status();
    if (!check_disk_space(folder_.scans(), summary.byte_count).is_ok())
      place = PreparedPlace::kMemory;
  }
  RETURN_IF_ERROR(charge());
  ASSIGN_OR_RETURN(mesh.prepared, read_prepared_mesh(path, place == PreparedPlace::kFile
                                                               ? ScratchSpace(folder_.scans(), 0)
                                                               : ScratchSpace()));
  return Status::ok();
}

Result<std::shared_ptr<SharedMesh>> MeshStore::read_charged(const std::string& id,
                                                            const PreparedKey& key) {
  const fs::path path = prepared_path(id, key);
  ASSIGN_OR_RETURN(const PreparedSummary summary, read_prepared_summary(path));
  auto mesh = std::make_shared<SharedMesh>();
  RETURN_IF_ERROR(hold_or_copy(path, summary, *mesh));
  ASSIGN_OR_RETURN(const uint64_t checksum, read_prepared_checksum(path));
  mesh->fingerprint = hierarchy_fingerprint(checksum);
  std::error_code ignored;  // a prepared file's time is its last opening
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return mesh;
}

// Maps files, so it waits for nobody who prepares.
Result<std::shared_ptr<SharedMesh>> MeshStore::read_kept(const std::string& id,
                                                         const PreparedKey& key,
                                                         const Progress& progress) {
  if (!fs::exists(hierarchy_path(id, key))) return not_found("no hierarchy is kept");
  ASSIGN_OR_RETURN(auto mesh, read_charged(id, key));
  RETURN_IF_ERROR(with_memory_for("the hierarchy of scan " + short_id(id), [&]() -> Status {
    return read_kept_hierarchy(id, key, *mesh, progress);
  }));
  return mesh;
}

Result<std::shared_ptr<SharedMesh>> MeshStore::read_with_hierarchy(const std::string& id,
                                                                   const PreparedKey& key,
                                                                   const std::string& user,
                                                                   const Progress& progress) {
  ASSIGN_OR_RETURN(auto turn, wait_to_prepare(id, user, progress));
  const Progress in_turn = turn.progress(progress);
  RETURN_IF_ERROR(make_prepared(id, key, in_turn));
  auto read = read_charged(id, key);
  if (can_be_made_again(read.status())) {
    spdlog::warn("preparing again: {}", read.status().message());
    RETURN_IF_ERROR(rebuild(id, key, in_turn));
    read = read_charged(id, key);
  }
  ASSIGN_OR_RETURN(auto mesh, std::move(read));
  RETURN_IF_ERROR(with_memory_for("the hierarchy of scan " + short_id(id), [&]() -> Status {
    return find_hierarchy(id, key, *mesh, in_turn);
  }));
  return mesh;
}

// Locks only this mesh: the trials of a plan take seconds, and other scans must go on.
Result<std::shared_ptr<const SharedMesh>> MeshStore::open_mesh(const std::string& id,
                                                               const PreparedKey& key,
                                                               const Progress& progress,
                                                               const std::string& user) {
  if (auto shared = cache_.find({id, key})) return shared;
  const std::shared_ptr<FairMutex> making = cache_.making({id, key});
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(*making, "waiting for another session of the scan", progress));
  if (auto shared = cache_.find({id, key})) return shared;
  RETURN_IF_ERROR(bring_here(id, progress));
  auto read = read_kept(id, key, progress);
  if (!read.is_ok() && read.status().code() != StatusCode::kCancelled)
    read = read_with_hierarchy(id, key, user, progress);
  ASSIGN_OR_RETURN(const auto mesh, std::move(read));
  if (!mesh->plan) RETURN_IF_ERROR(plan(id, *mesh, progress));
  // Dust has more than predicted: specks have corners at all depths.
  if (mesh->byte_count() > mesh->memory.amount())
    RETURN_IF_ERROR(mesh->memory.resize(mesh->byte_count()));
  cache_.add({id, key}, mesh);
  return std::shared_ptr<const SharedMesh>(mesh);
}

}  // namespace burnish

#include "server/library/mesh_store.h"

#include <algorithm>
#include <chrono>

#include <spdlog/spdlog.h>

#include "common/base/atomic_file.h"
#include "common/base/clock.h"
#include "common/grid/depth_plan.h"
#include "server/library/original_texels.h"
#include "server/library/read_original.h"
#include "server/library/scan_files.h"
#include "server/library/scan_record.h"
#include "server/memory/library_budget.h"
#include "server/prepare/pages/build_pages.h"
#include "server/prepare/prepare.h"

namespace burnish {

namespace fs = std::filesystem;

static ScanInfo make_scan_info(const std::string& id, const ImportHeader& header,
                               const PreparedMesh& prepared, const LibraryBudget& budget) {
  const MeshStatistics& s = prepared.statistics;
  ScanInfo scan;
  scan.id = id;
  scan.name = header.name;
  scan.format = header.format;
  scan.size_bytes = header.size_bytes;
  scan.imported_unix_seconds = unix_seconds_now();
  scan.default_depth = header.key.depth == 0 ? prepared.frame.depth
                                             : default_depth(s, budget.default_depth_bytes_max());
  scan.has_colours = !prepared.colours.empty();
  scan.statistics = s;
  return scan;
}

PreparedKey resolve(const PreparedKey& key, const ScanInfo& scan) {
  return {key.depth == 0 ? scan.default_depth : key.depth, key.curvature_radius};
}

MeshStore::MeshStore(const DataFolder& folder, const MeshStoreOptions& options)
    : folder_(folder),
      options_(options),
      memory_("bytes of meshes and sessions", "limits.memory_bytes_max", options.memory_bytes_max),
      uploads_("bytes of uploads under way", "limits.upload_bytes_per_user",
               options.upload_bytes_per_user) {}

MeshStore::~MeshStore() {
  is_ending_ = true;
}

Result<std::unique_ptr<MeshStore>> MeshStore::open(const DataFolder& folder,
                                                   const MeshStoreOptions& options) {
  std::unique_ptr<MeshStore> store(new MeshStore(folder, options));
  RETURN_IF_ERROR(store->index_.read(folder.scans()));
  return store;
}

fs::path MeshStore::prepared_path(const std::string& id, const PreparedKey& key) const {
  return scan_folder(id) / "prepared" / prepared_file_name(key);
}

Status MeshStore::read_again(const std::string& id) {
  const std::lock_guard lock(folders_mutex_);
  ASSIGN_OR_RETURN(ScanInfo scan, read_scan_folder(scan_folder(id)));
  index_.put(std::move(scan));
  return Status::ok();
}

Result<std::unique_ptr<Upload>> MeshStore::begin_upload(const ImportHeader& header,
                                                        const std::string& user) {
  if (header.size_bytes > options_.upload_bytes_max)
    return resource_exhausted("the file has " + std::to_string(header.size_bytes) +
                              " bytes; limits.upload_bytes_max is " +
                              std::to_string(options_.upload_bytes_max));
  Quota::Share share;
  if (!user.empty()) {
    ASSIGN_OR_RETURN(share, uploads_.take("user " + user, header.size_bytes));
  }
  return Upload::create(folder_.staging_path(".upload"), header.size_bytes, std::move(share));
}

Status MeshStore::check_new_name(const ImportHeader& header) {
  return names_.hold(header.sha256, header.name, header.exact_name).status();
}

Result<ImportOutcome> MeshStore::import(Upload& upload, const ImportHeader& header,
                                        const Progress& progress, const std::string& user) {
  ASSIGN_OR_RETURN(const std::string id, upload.finish());
  if (!header.sha256.empty() && header.sha256 != id)
    return data_loss("the received bytes have SHA-256 " + id + ", but " + header.sha256 +
                     " was announced");
  RETURN_IF_ERROR(take_upload(upload, id, progress));
  {
    const bool is_small = is_prepared_in_a_moment(upload.path(), header.format);
    ASSIGN_OR_RETURN(auto turn, preparing_.wait({user, id, is_small}, progress));
    unfinished_bake_.forget_others(id);
    const Progress in_turn = turn.progress(progress);
    const auto known = read_scan_folder(scan_folder(id));
    const StatusCode code = known.status().code();
    if (code == StatusCode::kNotFound || code == StatusCode::kDataLoss)
      return import_new(upload, id, header, in_turn);
    RETURN_IF_ERROR(known.status());
    const Status checked = check_original(scan_folder(id), *known, in_turn);
    if (checked.code() == StatusCode::kCancelled) return checked;
    if (!checked.is_ok()) RETURN_IF_ERROR(replace_original(scan_folder(id), *known, upload.path()));
  }
  RETURN_IF_ERROR(repair_shared(id, progress));
  return prepare_known(id, header.key, user, progress);
}

Result<ImportOutcome> MeshStore::import_new(Upload& upload, const std::string& id,
                                            const ImportHeader& header, const Progress& progress) {
  ASSIGN_OR_RETURN(const ScanNames::Hold name, names_.hold(id, header.name, header.exact_name));
  const StagingFolder staging(folder_.staging_path(".scan"));
  RETURN_IF_ERROR(staging.make("prepared"));
  const fs::path original = staging.path() / original_file_name(header.format);
  RETURN_IF_ERROR(move_path(upload.path(), original));

  if (!report(progress, "reading", 0)) return cancelled("the import was cancelled");
  LibraryBudget budget(memory_, folder_.scans(), options_.device_memory_bytes_max);
  RETURN_IF_ERROR(budget.ask_to_read(original, header.format));
  ASSIGN_OR_RETURN(const bool has_pictures, may_have_pictures(original, header.format));
  ASSIGN_OR_RETURN(const CountedTexels texels,
                   texels_of_original(original, header.format, header.name, budget, progress));
  ASSIGN_OR_RETURN(const auto mesh,
                   read_original(original, header.format, header.name, budget, progress));
  ASSIGN_OR_RETURN(auto prepared, prepare(mesh->view(), mesh,
                                          {header.key.depth, header.key.curvature_radius,
                                           options_.threads, &budget, budget.space()},
                                          progress));
  ScanInfo scan = make_scan_info(id, header, *prepared, budget);
  scan.name = name.name();
  const std::string prepared_name = prepared_file_name(resolve(header.key, scan));

  if (!report(progress, "storing", 0)) return cancelled("the import was cancelled");
  RETURN_IF_ERROR(
      write_prepared_mesh(*prepared, staging.path() / "prepared" / prepared_name, progress));
  prepared.reset();  // pages need the memory
  RETURN_IF_ERROR(build_pages(
      {mesh->vertices, mesh->triangles, mesh->colours, scan.statistics, texels.for_pages()},
      staging.path() / pages_file_name(has_pictures), {options_.threads, &budget, budget.space()},
      progress));
  RETURN_IF_ERROR(put_new(staging, scan, header, progress));
  ASSIGN_OR_RETURN(ScanInfo stored, find(id));
  return ImportOutcome{std::move(stored), false};
}

Result<ImportOutcome> MeshStore::import_known(const std::string& id, const PreparedKey& key,
                                              const Progress& progress, const std::string& user) {
  RETURN_IF_ERROR(refresh());
  Status status = bring_here(id, progress);
  const auto scan = read_scan_folder(scan_folder(id));
  if (status.is_ok())
    status = scan.is_ok() ? check_original(scan_folder(id), *scan, progress) : scan.status();
  if (status.code() == StatusCode::kCancelled) return status;
  if (!status.is_ok())
    return not_found("the server does not have these bytes: " + status.message());
  RETURN_IF_ERROR(repair_shared(id, progress));
  return prepare_known(id, key, user, progress);
}

Result<ImportOutcome> MeshStore::prepare_known(const std::string& id, const PreparedKey& key,
                                               const std::string& user, const Progress& progress) {
  ASSIGN_OR_RETURN(const ScanInfo scan, read_scan_folder(scan_folder(id)));
  RETURN_IF_ERROR(prepare_scan(id, resolve(key, scan), progress, user));
  RETURN_IF_ERROR(read_again(id));
  ASSIGN_OR_RETURN(ScanInfo now, find(id));
  return ImportOutcome{std::move(now), true};
}

Result<ScanDescription> MeshStore::describe(const std::string& reference, int depth) {
  ScanDescription description;
  ASSIGN_OR_RETURN(description.scan, find(reference));
  const auto& have = description.scan.prepared;
  const auto chosen = std::find_if(have.rbegin(), have.rend(), [&](const PreparedInfo& p) {
    return depth == 0 || p.key.depth == depth;
  });
  if (chosen == have.rend()) return description;
  ASSIGN_OR_RETURN(const PreparedSummary prepared,
                   read_prepared_summary(prepared_path(description.scan.id, chosen->key)));
  const CurvatureHistogram& histogram = prepared.histogram;
  description.prepared = PreparedDescription{chosen->key,
                                             prepared.length_unit,
                                             prepared.cell_size,
                                             prepared.cells,
                                             prepared.byte_count,
                                             histogram.range,
                                             {histogram.area.begin(), histogram.area.end()},
                                             prepared.walls};
  return description;
}

Result<ScanInfo> MeshStore::rename(const std::string& reference, const std::string& name) {
  ASSIGN_OR_RETURN(const ScanInfo found, find(reference));
  if (found.name == name) return found;
  ASSIGN_OR_RETURN(const ScanNames::Hold held, names_.hold(found.id, name, true));
  return change(found.id, [&](ScanInfo& scan) { scan.name = name; });
}

Result<ScanInfo> MeshStore::set_unit(const std::string& reference, const std::string& unit) {
  return change(reference, [&](ScanInfo& scan) { scan.unit = unit; });
}

Result<ScanInfo> MeshStore::change(const std::string& reference,
                                   const std::function<void(ScanInfo&)>& by) {
  ASSIGN_OR_RETURN(const ScanInfo found, find(reference));
  if (shared_) {
    const std::lock_guard lock(sharing_mutex_);
    mark_.clear();
    ASSIGN_OR_RETURN(const ScanInfo changed, shared_->catalogue->change(found.id, by));
    take_info(changed);
    return index_.find(found.id);
  }
  const fs::path folder = scan_folder(found.id);
  const std::lock_guard lock(folders_mutex_);
  ASSIGN_OR_RETURN(ScanInfo scan, read_scan_folder(folder));
  by(scan);
  RETURN_IF_ERROR(write_file(folder / "info.json", scan_to_json(scan)));
  index_.put(scan);
  return scan;
}

Status MeshStore::remove(const std::string& id) {
  std::error_code error;
  const bool is_there =
      is_content_hash(id) && (fs::exists(scan_folder(id), error) || index_.find_id(id));
  if (!is_there) return not_found("no scan has the id '" + id + "'");
  if (shared_) {
    const std::lock_guard lock(sharing_mutex_);
    mark_.clear();
    RETURN_IF_ERROR(shared_->catalogue->remove(id, [&] { return shared_->originals->remove(id); }));
    drop_here(id);
    return Status::ok();
  }
  const StagingFolder bin(folder_.staging_path(".deleted"));
  {
    const std::lock_guard lock(folders_mutex_);
    RETURN_IF_ERROR(move_path(scan_folder(id), bin.path()));
    index_.erase(id);
  }
  pages_.forget(id);
  sheets_.forget(id);
  unfinished_bake_.forget(id);
  return sync_folder(folder_.scans());
}

}  // namespace burnish

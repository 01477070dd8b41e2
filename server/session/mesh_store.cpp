#include "server/session/mesh_store.h"

#include <algorithm>
#include <chrono>

#include <spdlog/spdlog.h>

#include "common/base/atomic_file.h"
#include "common/base/mapped_file.h"
#include "common/grid/grid.h"
#include "common/mesh/mesh_io.h"
#include "server/prepare/prepare.h"
#include "server/session/cancellable_lock.h"
#include "server/session/memory_need.h"
#include "server/session/scan_files.h"
#include "server/session/scan_record.h"

namespace burnish {

namespace fs = std::filesystem;

namespace {

/// A folder that goes away with this object unless it was moved.
class StagingFolder {
 public:
  explicit StagingFolder(fs::path path) : path_(std::move(path)) {}
  ~StagingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Status move_path(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  return error ? errno_status("cannot move " + from.string() + " to " + to.string(), error.value())
               : Status::ok();
}

Status make_folders(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  return error ? errno_status("cannot make the folder " + path.string(), error.value())
               : Status::ok();
}

/// Reads a stored file under the name that its user knows.
Result<TriangleMesh> read_original(const fs::path& path, MeshFormat format,
                                   const std::string& name) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  return read_mesh(file.bytes(), format, name);
}

int64_t unix_seconds_now() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

ScanInfo make_scan_info(const std::string& id, const ImportHeader& header,
                        const PreparedMesh& prepared) {
  const MeshStatistics& s = prepared.statistics;
  ScanInfo scan;
  scan.id = id;
  scan.name = header.name;
  scan.format = header.format;
  scan.size_bytes = header.size_bytes;
  scan.imported_unix_seconds = unix_seconds_now();
  scan.default_depth = default_depth(s.box_min, s.box_max, s.mean_edge_length);
  scan.has_colours = !prepared.colours.empty();
  scan.statistics = s;
  return scan;
}

}  // namespace

PreparedKey resolve(const PreparedKey& key, const ScanInfo& scan) {
  return {key.depth == 0 ? scan.default_depth : key.depth, key.curvature_radius};
}

MeshStore::MeshStore(const DataFolder& folder, const MeshStoreOptions& options)
    : folder_(folder),
      options_(options),
      views_(options.view_bytes_max),
      memory_("bytes of meshes and sessions", "limits.memory_bytes_max", options.memory_bytes_max),
      uploads_("bytes of uploads under way", "limits.upload_bytes_per_user",
               options.upload_bytes_per_user) {}

Result<std::unique_ptr<Upload>> MeshStore::begin_upload(const ImportHeader& header,
                                                        const std::string& user) {
  if (header.size_bytes > options_.upload_bytes_max)
    return resource_exhausted("the file has " + std::to_string(header.size_bytes) +
                              " bytes; upload_bytes_max is " +
                              std::to_string(options_.upload_bytes_max));
  Quota::Share share;
  if (!user.empty()) {
    ASSIGN_OR_RETURN(share, uploads_.take("user " + user, header.size_bytes));
  }
  return Upload::create(folder_.staging_path(".upload"), header.size_bytes, std::move(share));
}

Result<ImportOutcome> MeshStore::import(Upload& upload, const ImportHeader& header,
                                        const Progress& progress) {
  ASSIGN_OR_RETURN(const std::string id, upload.finish());
  if (!header.sha256.empty() && header.sha256 != id)
    return data_loss("the bytes that came have SHA-256 " + id + ", announced was " + header.sha256);
  {
    ASSIGN_OR_RETURN(const auto lock,
                     lock_or_cancel(preparing_, "waiting for another scan", progress));
    const auto known = read_scan_folder(scan_folder(id));
    if (!known.is_ok()) return import_new(upload, id, header, progress);
    if (!check_original(scan_folder(id), *known).is_ok())
      RETURN_IF_ERROR(replace_original(scan_folder(id), *known, upload.path()));
  }
  return prepare_known(id, header.key, progress);
}

Result<ImportOutcome> MeshStore::import_new(Upload& upload, const std::string& id,
                                            const ImportHeader& header, const Progress& progress) {
  const StagingFolder staging(folder_.staging_path(".scan"));
  RETURN_IF_ERROR(make_folders(staging.path() / "prepared"));
  const fs::path original = staging.path() / original_file_name(header.format);
  RETURN_IF_ERROR(move_path(upload.path(), original));

  if (!report(progress, "reading", 0)) return cancelled("the import was cancelled");
  ASSIGN_OR_RETURN(const TriangleMesh mesh, read_original(original, header.format, header.name));
  ASSIGN_OR_RETURN(
      const auto prepared,
      prepare(mesh, {header.key.depth, header.key.curvature_radius, options_.threads}, progress));
  const ScanInfo scan = make_scan_info(id, header, *prepared);
  const std::string prepared_name = prepared_file_name(resolve(header.key, scan));

  if (!report(progress, "storing", 0)) return cancelled("the import was cancelled");
  RETURN_IF_ERROR(write_prepared_mesh(*prepared, staging.path() / "prepared" / prepared_name));
  RETURN_IF_ERROR(write_file(staging.path() / "info.json", scan_to_json(scan)));
  RETURN_IF_ERROR(sync_folder(staging.path()));
  RETURN_IF_ERROR(put_scan_in_place(staging.path(), scan_folder(id)));
  RETURN_IF_ERROR(sync_folder(folder_.scans()));
  ASSIGN_OR_RETURN(ScanInfo stored, read_scan_folder(scan_folder(id)));
  return ImportOutcome{std::move(stored), false};
}

Result<ImportOutcome> MeshStore::import_known(const std::string& id, const PreparedKey& key,
                                              const Progress& progress) {
  const auto scan = read_scan_folder(scan_folder(id));
  const Status status = scan.is_ok() ? check_original(scan_folder(id), *scan) : scan.status();
  if (!status.is_ok()) return not_found("the library needs the bytes: " + status.message());
  return prepare_known(id, key, progress);
}

Result<ImportOutcome> MeshStore::prepare_known(const std::string& id, const PreparedKey& key,
                                               const Progress& progress) {
  ASSIGN_OR_RETURN(const ScanInfo scan, read_scan_folder(scan_folder(id)));
  RETURN_IF_ERROR(prepare_scan(id, resolve(key, scan), progress));
  ASSIGN_OR_RETURN(ScanInfo now, read_scan_folder(scan_folder(id)));
  return ImportOutcome{std::move(now), true};
}

std::vector<ScanInfo> MeshStore::list() const {
  std::vector<ScanInfo> scans;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_.scans(), error)) {
    auto scan = read_scan_folder(entry.path());
    if (scan.is_ok()) {
      scans.push_back(std::move(*scan));
    } else {
      spdlog::warn("scan left out: {}", scan.status().message());
    }
  }
  std::sort(scans.begin(), scans.end(), [](const ScanInfo& a, const ScanInfo& b) {
    return std::tie(a.name, a.id) < std::tie(b.name, b.id);
  });
  return scans;
}

Result<ScanInfo> MeshStore::find(const std::string& reference) const {
  std::vector<ScanInfo> named, begun;
  for (ScanInfo& scan : list()) {
    if (scan.id == reference) return std::move(scan);
    if (scan.name == reference) {
      named.push_back(std::move(scan));
    } else if (!reference.empty() && scan.id.starts_with(reference)) {
      begun.push_back(std::move(scan));
    }
  }
  std::vector<ScanInfo>& answers = named.empty() ? begun : named;
  if (answers.empty()) return not_found("no scan has the name or id '" + reference + "'");
  if (answers.size() > 1)
    return invalid_argument(std::to_string(answers.size()) + " scans answer to '" + reference +
                            "', among them " + short_id(answers[0].id) + " and " +
                            short_id(answers[1].id) + "; name one by its id");
  return std::move(answers[0]);
}

Result<ScanDescription> MeshStore::describe(const std::string& reference, int depth) const {
  ScanDescription description;
  ASSIGN_OR_RETURN(description.scan, find(reference));
  const auto& have = description.scan.prepared;
  const auto chosen = std::find_if(have.rbegin(), have.rend(), [&](const PreparedInfo& p) {
    return depth == 0 || p.key.depth == depth;
  });
  if (chosen == have.rend()) return description;
  ASSIGN_OR_RETURN(const auto mesh,
                   map_prepared_mesh(scan_folder(description.scan.id) / "prepared" /
                                     prepared_file_name(chosen->key)));
  const CurvatureHistogram& histogram = mesh->histogram;
  description.prepared = PreparedDescription{chosen->key,
                                             mesh->length_unit,
                                             mesh->frame.cell_size,
                                             mesh->cells.size(),
                                             mesh->byte_count(),
                                             histogram.range,
                                             {histogram.area.begin(), histogram.area.end()}};
  return description;
}

Status MeshStore::prepare_scan(const std::string& id, const PreparedKey& key,
                               const Progress& progress) {
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(preparing_, "waiting for another scan", progress));
  return map_or_rebuild(id, key, progress).status();
}

Result<std::shared_ptr<const SharedMesh>> MeshStore::open_mesh(const std::string& id,
                                                               const PreparedKey& key,
                                                               const Progress& progress) {
  if (auto shared = cache_.find({id, key})) return shared;
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(preparing_, "waiting for another scan", progress));
  if (auto shared = cache_.find({id, key})) return shared;
  auto mesh = std::make_shared<SharedMesh>();
  ASSIGN_OR_RETURN(mesh->prepared, map_or_rebuild(id, key, progress));
  ASSIGN_OR_RETURN(mesh->memory, memory_.take(kServer, predict_mesh_bytes(*mesh->prepared)));
  mesh->hierarchy = make_hierarchy(*mesh->prepared);
  if (mesh->byte_count() > mesh->memory.amount()) {  // dust: specks have corners at all depths
    mesh->memory = Quota::Share();
    ASSIGN_OR_RETURN(mesh->memory, memory_.take(kServer, mesh->byte_count()));
  }
  cache_.add({id, key}, mesh);
  return std::shared_ptr<const SharedMesh>(std::move(mesh));
}

Result<std::shared_ptr<const PreparedMesh>> MeshStore::map_or_rebuild(const std::string& id,
                                                                      const PreparedKey& key,
                                                                      const Progress& progress) {
  const fs::path path = scan_folder(id) / "prepared" / prepared_file_name(key);
  auto mapped = map_prepared_mesh(path);
  if (mapped.is_ok()) return mapped;
  const StatusCode code = mapped.status().code();
  if (code != StatusCode::kNotFound && code != StatusCode::kDataLoss) return mapped;
  if (code == StatusCode::kDataLoss) spdlog::warn("preparing again: {}", mapped.status().message());
  RETURN_IF_ERROR(rebuild(id, key, progress));
  return map_prepared_mesh(path);
}

Status MeshStore::rebuild(const std::string& id, const PreparedKey& key, const Progress& progress) {
  const fs::path folder = scan_folder(id);
  ASSIGN_OR_RETURN(const ScanInfo scan, read_scan_folder(folder));
  if (!report(progress, "reading", 0)) return cancelled("preparing was cancelled");
  RETURN_IF_ERROR(check_original(folder, scan));
  ASSIGN_OR_RETURN(const TriangleMesh mesh,
                   read_original(folder / original_file_name(scan.format), scan.format, scan.name));
  ASSIGN_OR_RETURN(const auto prepared,
                   prepare(mesh, {key.depth, key.curvature_radius, options_.threads}, progress));
  return write_prepared_mesh(*prepared, folder / "prepared" / prepared_file_name(key));
}

Status MeshStore::remove(const std::string& id) {
  std::error_code error;
  if (!is_content_hash(id) || !fs::exists(scan_folder(id), error))
    return not_found("no scan has the id '" + id + "'");
  const StagingFolder bin(folder_.staging_path(".deleted"));
  RETURN_IF_ERROR(move_path(scan_folder(id), bin.path()));
  return sync_folder(folder_.scans());
}

}  // namespace burnish

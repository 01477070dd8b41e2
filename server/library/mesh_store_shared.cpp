// The part of MeshStore that shares scans with other servers. A scan's folder has the file `shared`
// once the catalogue has the scan: if it is not in the catalogue later, another server has deleted
// it. A change of this server clears the mark of the last reading: others may undo it before the
// next one, and the catalogue has the old mark again.

#include <deque>
#include <set>

#include <spdlog/spdlog.h>

#include "common/base/atomic_file.h"
#include "server/library/mesh_store.h"
#include "server/library/scan_files.h"
#include "server/library/scan_record.h"
#include "server/memory/library_budget.h"
#include "server/scheduling/cancellable_lock.h"

namespace burnish {

namespace fs = std::filesystem;

static constexpr char kMark[] = "shared";

bool MeshStore::is_here(const std::string& id) const {
  std::error_code error;
  return fs::exists(scan_folder(id) / "info.json", error);
}

Result<ScanInfo> MeshStore::find(const std::string& reference) {
  auto found = index_.find(reference);
  if (!shared_ || found.status().code() != StatusCode::kNotFound) return found;
  RETURN_IF_ERROR(refresh());
  return index_.find(reference);
}

std::string MeshStore::name_of(const std::string& id) const {
  const auto scan = index_.find_id(id);
  return scan ? scan->name : id;
}

Status MeshStore::share(SharedLibrary shared) {
  shared_ = std::move(shared);
  RETURN_IF_ERROR(refresh());  // forgets what others have deleted, which must not come back
  for (const ScanInfo& scan : index_.list()) {
    std::error_code error;
    if (!is_here(scan.id) || fs::exists(scan_folder(scan.id) / kMark, error)) continue;
    RETURN_IF_ERROR(share_own(scan));
  }
  return Status::ok();
}

/// Shares a scan that this server has had alone. A damaged one stays as it is.
Status MeshStore::share_own(const ScanInfo& scan) {
  const fs::path folder = scan_folder(scan.id);
  ASSIGN_OR_RETURN(const ScanInfo read, read_scan_folder(folder));
  const auto staged =
      shared_->originals->copy_in(folder / original_file_name(scan.format), read, {});
  if (staged.status().code() == StatusCode::kDataLoss) return Status::ok();
  RETURN_IF_ERROR(staged.status());
  const std::lock_guard lock(sharing_mutex_);
  mark_.clear();
  ASSIGN_OR_RETURN(const ScanInfo entered,
                   enter_new(read, read.name, false, [&] { return staged.value()->place(false); }));
  RETURN_IF_ERROR(write_file(folder / kMark, ""));
  take_info(entered);
  return Status::ok();
}

Status MeshStore::refresh() {
  if (!shared_) return Status::ok();
  const std::lock_guard lock(sharing_mutex_);
  return read_catalogue();
}

Status MeshStore::refresh_unless_busy() {
  if (!shared_) return Status::ok();
  const std::unique_lock lock(sharing_mutex_, std::try_to_lock);
  return lock ? read_catalogue() : Status::ok();
}

/// Needs: sharing_mutex_ is held.
Status MeshStore::read_catalogue() {
  ASSIGN_OR_RETURN(const auto page, shared_->catalogue->read(mark_));
  if (!page) return Status::ok();
  std::set<std::string> there;
  for (const ScanInfo& scan : page->scans) {
    there.insert(scan.id);
    take_info(scan);
  }
  for (const ScanInfo& scan : index_.list()) {
    std::error_code error;
    const bool is_own = is_here(scan.id) && !fs::exists(scan_folder(scan.id) / kMark, error);
    if (!there.contains(scan.id) && !is_own) drop_here(scan.id);
  }
  mark_ = page->mark;
  return Status::ok();
}

/// Takes in what the catalogue says of a scan. Only its name and its unit ever change.
void MeshStore::take_info(const ScanInfo& scan) {
  const std::lock_guard lock(folders_mutex_);
  const auto known = index_.find_id(scan.id);
  if (known && known->name == scan.name && known->unit == scan.unit) return;
  ScanInfo now = scan;
  if (is_here(scan.id)) {
    const auto here = read_scan_folder(scan_folder(scan.id));
    if (here.is_ok()) now.prepared = here->prepared;
    const Status written = write_file(scan_folder(scan.id) / "info.json", scan_to_json(scan));
    if (!written.is_ok()) spdlog::warn("scan {}: {}", scan.id, written.message());
  }
  index_.put(std::move(now));
}

/// Removes what this server has of a scan that is in the catalogue no more.
void MeshStore::drop_here(const std::string& id) {
  const StagingFolder bin(folder_.staging_path(".deleted"));
  {
    const std::lock_guard lock(folders_mutex_);
    std::error_code ignored;
    fs::rename(scan_folder(id), bin.path(), ignored);
    index_.erase(id);
  }
  pages_.forget(id);
  sheets_.forget(id);
  unfinished_bake_.forget(id);
}

Status MeshStore::bring_here(const std::string& id, const Progress& progress) {
  if (!shared_ || is_here(id)) return Status::ok();
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(fetching_, "waiting for another scan", progress));
  const auto scan = index_.find_id(id);
  if (!scan || is_here(id)) return Status::ok();
  RETURN_IF_ERROR(check_disk_space(folder_.scans(), scan->size_bytes));
  const StagingFolder staging(folder_.staging_path(".scan"));
  RETURN_IF_ERROR(staging.make("prepared"));
  RETURN_IF_ERROR(shared_->originals->fetch(
      *scan, staging.path() / original_file_name(scan->format), progress));
  spdlog::info("scan {} fetched from the fleet's originals", short_id(id));
  return take_fetched(staging, *scan);
}

/// Puts a staged scan of the catalogue in its place, unless it was deleted meanwhile.
Status MeshStore::take_fetched(const StagingFolder& staging, const ScanInfo& scan) {
  const std::lock_guard lock(sharing_mutex_);
  const auto now = index_.find_id(scan.id);
  if (!now) return not_found("scan " + scan.name + " was deleted on another server");
  return put_shared_here(staging, *now);
}

Status MeshStore::put_shared_here(const StagingFolder& staging, const ScanInfo& scan) {
  RETURN_IF_ERROR(write_file(staging.path() / kMark, ""));
  return put_here(staging, scan);
}

Status MeshStore::put_here(const StagingFolder& staging, const ScanInfo& scan) {
  RETURN_IF_ERROR(write_file(staging.path() / "info.json", scan_to_json(scan)));
  RETURN_IF_ERROR(sync_folder(staging.path()));
  RETURN_IF_ERROR(put_scan_in_place(staging.path(), scan_folder(scan.id)));
  RETURN_IF_ERROR(sync_folder(folder_.scans()));
  return read_again(scan.id);
}

/// Shares a new scan, then puts it among this server's own: if it cannot be shared, nothing is
/// kept.
Status MeshStore::put_new(const StagingFolder& staging, const ScanInfo& scan,
                          const ImportHeader& header, const Progress& progress) {
  if (!shared_) return put_here(staging, scan);
  ASSIGN_OR_RETURN(const auto staged,
                   shared_->originals->copy_in(staging.path() / original_file_name(scan.format),
                                               scan, progress));
  const std::lock_guard lock(sharing_mutex_);
  mark_.clear();
  ASSIGN_OR_RETURN(const ScanInfo entered, enter_new(scan, header.name, header.exact_name,
                                                     [&] { return staged->place(false); }));
  return put_shared_here(staging, entered);
}

/// Enters a scan. Another server may have given its name since it was chosen: unless it must be
/// exact, the scan gets the next number. Needs: sharing_mutex_ is held.
Result<ScanInfo> MeshStore::enter_new(ScanInfo scan, const std::string& wanted, bool exact,
                                      const ScanCatalogue::Files& put) {
  constexpr size_t kNamesMax = 100;
  std::deque<ScanNames::Hold> refused;  // held, so that the next one differs
  for (;;) {
    auto entered = shared_->catalogue->enter(scan, put);
    if (entered.status().code() != StatusCode::kAlreadyExists || exact ||
        refused.size() == kNamesMax)
      return entered;
    ASSIGN_OR_RETURN(ScanNames::Hold next, names_.hold(scan.id, wanted, false));
    scan.name = next.name();
    refused.push_back(std::move(next));
  }
}

/// Uses the uploaded bytes of a scan that others have imported. What the fleet has may be
/// damaged, so the upload counts.
Status MeshStore::take_upload(Upload& upload, const std::string& id, const Progress& progress) {
  RETURN_IF_ERROR(refresh());
  const auto scan = index_.find_id(id);
  if (!shared_ || !scan || is_here(id)) return Status::ok();
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(fetching_, "waiting for another scan", progress));
  if (is_here(id)) return Status::ok();
  const StagingFolder staging(folder_.staging_path(".scan"));
  RETURN_IF_ERROR(staging.make("prepared"));
  RETURN_IF_ERROR(move_path(upload.path(), staging.path() / original_file_name(scan->format)));
  return take_fetched(staging, *scan);
}

/// Makes the shared original good again by this server's own. Needs: its own is good.
Status MeshStore::repair_shared(const std::string& id, const Progress& progress) {
  const auto scan = index_.find_id(id);
  if (!shared_ || !scan) return Status::ok();
  const Status status = shared_->originals->check(*scan, progress);
  if (status.code() != StatusCode::kDataLoss) return status;
  ASSIGN_OR_RETURN(const auto staged,
                   shared_->originals->copy_in(scan_folder(id) / original_file_name(scan->format),
                                               *scan, progress));
  const std::lock_guard lock(sharing_mutex_);
  mark_.clear();
  spdlog::warn("scan {}: its original in the fleet's store was damaged and is replaced", id);
  return shared_->catalogue->enter(*scan, [&] { return staged->place(true); }).status();
}

/// Checks the original, and fetches it again if it is damaged.
Status MeshStore::check_or_fetch(const ScanInfo& scan, const Progress& progress) {
  const fs::path folder = scan_folder(scan.id);
  const Status checked = check_original(folder, scan, progress);
  if (checked.code() != StatusCode::kDataLoss || !shared_) return checked;
  const StagingFolder good(folder_.staging_path(".original"));
  const Status fetched = shared_->originals->fetch(scan, good.path(), progress);
  if (fetched.code() == StatusCode::kDataLoss) return checked;
  RETURN_IF_ERROR(fetched);
  return replace_original(folder, scan, good.path());
}

}  // namespace burnish

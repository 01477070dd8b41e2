#include "server/library/shared_folder.h"

#include <spdlog/spdlog.h>

#include "common/base/atomic_file.h"
#include "server/library/checked_copy.h"
#include "server/library/data_folder.h"
#include "server/library/scan_record.h"

namespace burnish {

namespace fs = std::filesystem;

static constexpr char kSharedFolder[] = "shared folder";

class SharedFolder::Staged final : public StagedOriginal {
 public:
  Staged(SharedFolder& store, ScanInfo scan)
      : store_(store), scan_(std::move(scan)), files_(store.staging_path()) {}

  const StagingFolder& files() const { return files_; }
  Status place(bool replaces) override { return store_.place(files_, scan_, replaces); }

 private:
  SharedFolder& store_;
  const ScanInfo scan_;
  const StagingFolder files_;
};

Status rename_once(const fs::path& from, const fs::path& to,
                   const std::function<bool()>& is_there) {
  std::error_code error;
  fs::rename(from, to, error);
  if (!error || is_there()) return Status::ok();
  return errno_status("cannot move " + from.string() + " to " + to.string(), error.value());
}

Result<std::unique_ptr<SharedFolder>> SharedFolder::open(const fs::path& path,
                                                         const std::string& server) {
  std::error_code error;
  if (!fs::is_directory(path, error))
    return not_found("library.shared = '" + path.string() + "' is not a folder; is it mounted?");
  std::unique_ptr<SharedFolder> folder(new SharedFolder(path, path / "staging" / server));
  fs::remove_all(folder->staging_, error);
  if (!error) fs::create_directories(folder->staging_, error);
  if (!error) fs::create_directories(path / "scans", error);
  if (error) return errno_status("cannot make folders in " + path.string(), error.value());
  return folder;
}

fs::path SharedFolder::original(const ScanInfo& scan) const {
  return path_ / "scans" / scan.id / original_file_name(scan.format);
}

fs::path SharedFolder::staging_path() const {
  return staging_ / random_name();
}

bool SharedFolder::is_whole(const ScanInfo& scan) const {
  std::error_code error;
  return fs::file_size(original(scan), error) == scan.size_bytes && !error;
}

Result<std::unique_ptr<StagedOriginal>> SharedFolder::copy_in(const fs::path& original,
                                                              const ScanInfo& scan,
                                                              const Progress& progress) {
  auto copy = std::make_unique<Staged>(*this, scan);
  const StagingFolder& staged = copy->files();
  Status status = staged.make();
  if (status.is_ok())
    status = copy_checked(original, scan.id, staged.path() / original_file_name(scan.format),
                          as_phase("sharing", progress));
  if (status.is_ok()) status = write_new_file(staged.path() / "info.json", scan_to_json(scan));
  if (status.is_ok()) status = sync_folder(staged.path());
  RETURN_IF_ERROR(told_apart(status, kSharedFolder, "sharing", scan));
  return std::unique_ptr<StagedOriginal>(std::move(copy));
}

Status SharedFolder::place(const StagingFolder& staged, const ScanInfo& scan, bool replaces) {
  const fs::path to = path_ / "scans" / scan.id;
  const StagingFolder bin(staging_path());
  std::error_code none;
  if (replaces || !is_whole(scan)) fs::rename(to, bin.path(), none);
  const Status placed = rename_once(staged.path(), to, [&] { return is_whole(scan); });
  RETURN_IF_ERROR(told_apart(placed, kSharedFolder, "sharing", scan));
  return told_apart(sync_folder(path_ / "scans"), kSharedFolder, "sharing", scan);
}

Status SharedFolder::check(const ScanInfo& scan, const Progress& progress) const {
  return told_apart(check_file(original(scan), scan.id, as_phase("checking", progress)),
                    kSharedFolder, "checking", scan);
}

Status SharedFolder::fetch(const ScanInfo& scan, const fs::path& to,
                           const Progress& progress) const {
  return told_apart(copy_checked(original(scan), scan.id, to, progress), kSharedFolder, "fetching",
                    scan);
}

Status SharedFolder::remove(const std::string& id) {
  const fs::path from = path_ / "scans" / id;
  const StagingFolder bin(staging_path());
  const Status moved = rename_once(from, bin.path(), [&] {
    std::error_code error;
    return !fs::exists(from, error) && !error;
  });
  if (moved.is_ok()) return moved;
  spdlog::error("{}: {}", kSharedFolder, moved.message());
  return {moved.code(), "deleting the original in the shared folder failed; see the log"};
}

}  // namespace burnish

#include "server/library/scan_files.h"

#include <spdlog/spdlog.h>

#include "common/base/atomic_file.h"
#include "server/library/checked_copy.h"
#include "server/library/data_folder.h"
#include "server/library/original_store.h"
#include "server/library/scan_record.h"

namespace burnish {

namespace fs = std::filesystem;

Status move_path(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  return error ? errno_status("cannot move " + from.string() + " to " + to.string(), error.value())
               : Status::ok();
}

Status make_prepared_folder(const fs::path& scan) {
  std::error_code error;
  const bool is_new = fs::create_directories(scan / "prepared", error);
  if (is_new && !error) fs::permissions(scan, fs::perms::owner_all, error);
  return error
             ? errno_status("cannot make the folder " + (scan / "prepared").string(), error.value())
             : Status::ok();
}

Status check_original(const fs::path& folder, const ScanInfo& scan, const Progress& progress) {
  const fs::path path = folder / original_file_name(scan.format);
  const Status checked = check_file(path, scan.id, as_phase("reading", progress));
  const bool is_damaged =
      checked.code() == StatusCode::kDataLoss || checked.code() == StatusCode::kNotFound;
  if (!is_damaged) return checked;
  return data_loss("the original of scan " + scan.name + " is damaged (" + path.string() +
                   "); import the same file again");
}

Status replace_original(const fs::path& folder, const ScanInfo& scan, const fs::path& good) {
  spdlog::warn("scan {}: its original was damaged and is replaced; the scan is prepared again",
               scan.id);
  RETURN_IF_ERROR(move_path(good, folder / original_file_name(scan.format)));
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "prepared", error))
    fs::remove(entry.path(), error);
  return sync_folder(folder);
}

Status put_scan_in_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  if (!fs::exists(to, error)) return move_path(from, to);
  spdlog::warn("scan {}: its info.json was damaged and is replaced", to.filename().string());
  fs::create_directories(to / "prepared", error);
  for (const auto& entry : fs::directory_iterator(from / "prepared", error))
    RETURN_IF_ERROR(move_path(entry.path(), to / "prepared" / entry.path().filename()));
  for (const auto& entry : fs::directory_iterator(from, error)) {
    const fs::path name = entry.path().filename();
    if (name != "prepared" && name != "info.json") RETURN_IF_ERROR(move_path(entry, to / name));
  }
  // Moved last: with it the folder is a scan again.
  RETURN_IF_ERROR(move_path(from / "info.json", to / "info.json"));
  return sync_folder(to);
}

}  // namespace burnish

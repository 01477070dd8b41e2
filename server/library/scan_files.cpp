#include "server/library/scan_files.h"

#include <spdlog/spdlog.h>

#include "common/base/atomic_file.h"
#include "common/base/mapped_file.h"
#include "common/transfer/content_hash.h"
#include "server/library/data_folder.h"
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

Status check_original(const fs::path& folder, const ScanInfo& scan) {
  const fs::path path = folder / original_file_name(scan.format);
  const auto file = MappedFile::open(path);
  if (file.is_ok()) {
    ContentHash hash;
    hash.update({reinterpret_cast<const char*>(file->bytes().data()), file->bytes().size()});
    if (hash.finish() == scan.id) return Status::ok();
  } else if (file.status().code() != StatusCode::kNotFound) {
    return file.status();
  }
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

#include "server/library/stale_files.h"

#include <fstream>
#include <optional>
#include <string>

#include <spdlog/spdlog.h>

#include "common/pages/page_format.h"
#include "common/sheets/sheet_format.h"
#include "server/library/scan_record.h"
#include "server/prepare/prepared_file.h"
#include "server/solver/kept/hierarchy_file.h"
#include "server/solver/kept/hierarchy_format.h"

namespace burnish {

namespace fs = std::filesystem;

static bool is_scan_id(const std::string& name) {
  return name.size() == 64 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

namespace {

/// The files of one kind, by their names and their first bytes.
struct FileKind {
  std::string suffix;
  std::string first_bytes;
  uint32_t version;  ///< that this server writes
  std::optional<uint32_t> (*version_of)(const std::string& name);
};

bool begins_as_we_write(const fs::path& path, const FileKind& kind) {
  std::string begin(kind.first_bytes.size(), 0);
  std::ifstream file(path, std::ios::binary);
  return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) &&
         begin == kind.first_bytes;
}

// AtomicFile's names: "NAME.PID-NUMBER.tmp".
bool is_half_written(const std::string& name, const FileKind& kind) {
  static const std::string kEnd = ".tmp";
  const size_t at = name.find(kind.suffix + ".");
  if (at == std::string::npos || !name.ends_with(kEnd)) return false;
  const size_t begin = at + kind.suffix.size() + 1;
  const std::string numbers = name.substr(begin, name.size() - kEnd.size() - begin);
  return numbers.find_first_not_of("0123456789-") == std::string::npos &&
         kind.version_of(name.substr(0, at + kind.suffix.size()));
}

bool is_stale(const fs::directory_entry& entry, uint64_t bytes, const FileKind& kind) {
  const std::string name = entry.path().filename().string();
  if (is_half_written(name, kind)) return bytes == 0 || begins_as_we_write(entry.path(), kind);
  const auto version = kind.version_of(name);
  return version && *version != kind.version && begins_as_we_write(entry.path(), kind);
}

void remove_if_stale(const fs::directory_entry& entry, const FileKind& kind,
                     RemovedFiles& removed) {
  std::error_code error;
  if (entry.symlink_status(error).type() != fs::file_type::regular) return;
  const uint64_t bytes = entry.file_size(error);
  if (error || !is_stale(entry, bytes, kind) || !fs::remove(entry.path(), error)) return;
  ++removed.count;
  removed.bytes += bytes;
}

std::error_code remove_from(const fs::path& folder, const FileKind& kind, RemovedFiles& removed) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    remove_if_stale(*entry, kind, removed);
  const bool has_none =
      error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
  return has_none ? std::error_code() : error;
}

std::error_code remove_of_scan(const fs::path& scan, RemovedFiles& removed) {
  static const FileKind kPrepared{".prepared",
                                  {kPreparedMagic.begin(), kPreparedMagic.end()},
                                  kPreparedFormatVersion,
                                  prepared_file_version};
  static const FileKind kHierarchies{".hierarchy",
                                     {kHierarchyMagic.begin(), kHierarchyMagic.end()},
                                     kHierarchyFormatVersion,
                                     hierarchy_file_version};
  static const FileKind kPages{
      ".pages", {kPageMagic.begin(), kPageMagic.end()}, kPageFormatVersion, pages_file_version};
  static const FileKind kSheets{".sheets",
                                {kSheetMagic.begin(), kSheetMagic.end()},
                                kSheetFormatVersion,
                                sheets_file_version};
  std::error_code failure = remove_from(scan, kPages, removed);
  if (!failure) failure = remove_from(scan, kSheets, removed);
  if (!failure) failure = remove_from(scan / "prepared", kHierarchies, removed);
  return failure ? failure : remove_from(scan / "prepared", kPrepared, removed);
}

}  // namespace

RemovedFiles remove_stale_files(const DataFolder& folder) {
  RemovedFiles removed;
  std::error_code error;
  fs::directory_iterator scan(folder.scans(), error);
  for (; !error && scan != fs::directory_iterator(); scan.increment(error)) {
    if (!is_scan_id(scan->path().filename().string())) continue;
    const std::error_code failure = remove_of_scan(scan->path(), removed);
    if (failure)  // a failed folder must not stop the others
      spdlog::warn("cannot remove outdated files of {}: {}", scan->path().string(),
                   failure.message());
  }
  if (removed.count > 0)
    spdlog::info("removed {} outdated files of scans, {} bytes", removed.count, removed.bytes);
  return removed;
}

}  // namespace burnish

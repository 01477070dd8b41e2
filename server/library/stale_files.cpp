#include "server/library/stale_files.h"

#include <array>
#include <fstream>
#include <string>

#include <spdlog/spdlog.h>

#include "server/library/scan_record.h"
#include "server/prepare/prepared_file.h"

namespace burnish {

namespace fs = std::filesystem;

static bool is_scan_id(const std::string& name) {
  return name.size() == 64 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

static bool begins_as_we_write(const fs::path& path) {
  std::array<char, kPreparedMagic.size()> begin = {};
  std::ifstream file(path, std::ios::binary);
  return file.read(begin.data(), begin.size()) && begin == kPreparedMagic;
}

// AtomicFile's names: "NAME.PID-NUMBER.tmp".
static bool is_half_written(const std::string& name) {
  static const std::string kPrepared = ".prepared", kEnd = ".tmp";
  const size_t at = name.find(kPrepared + ".");
  if (at == std::string::npos || !name.ends_with(kEnd)) return false;
  const size_t begin = at + kPrepared.size() + 1;
  const std::string numbers = name.substr(begin, name.size() - kEnd.size() - begin);
  return numbers.find_first_not_of("0123456789-") == std::string::npos &&
         prepared_file_version(name.substr(0, at + kPrepared.size()));
}

static bool is_stale(const fs::directory_entry& entry, uint64_t bytes) {
  const std::string name = entry.path().filename().string();
  if (is_half_written(name)) return bytes == 0 || begins_as_we_write(entry.path());
  const auto version = prepared_file_version(name);
  return version && *version != kPreparedFormatVersion && begins_as_we_write(entry.path());
}

static void remove_if_stale(const fs::directory_entry& entry, RemovedFiles& removed) {
  std::error_code error;
  if (entry.symlink_status(error).type() != fs::file_type::regular) return;
  const uint64_t bytes = entry.file_size(error);
  if (error || !is_stale(entry, bytes) || !fs::remove(entry.path(), error)) return;
  ++removed.count;
  removed.bytes += bytes;
}

static std::error_code remove_of_scan(const fs::path& scan, RemovedFiles& removed) {
  std::error_code error;
  fs::directory_iterator entry(scan / "prepared", error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    remove_if_stale(*entry, removed);
  const bool has_none =
      error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
  return has_none ? std::error_code() : error;
}

RemovedFiles remove_stale_files(const DataFolder& folder) {
  RemovedFiles removed;
  std::error_code error;
  fs::directory_iterator scan(folder.scans(), error);
  for (; !error && scan != fs::directory_iterator(); scan.increment(error)) {
    if (!is_scan_id(scan->path().filename().string())) continue;
    const std::error_code failure = remove_of_scan(scan->path(), removed);
    if (failure)  // a failed folder must not stop the others
      spdlog::warn("cannot remove stale prepared files of {}: {}", scan->path().string(),
                   failure.message());
  }
  if (removed.count > 0)
    spdlog::info("removed {} outdated prepared files, {} bytes", removed.count, removed.bytes);
  return removed;
}

}  // namespace burnish

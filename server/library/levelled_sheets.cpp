#include "server/library/levelled_sheets.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "common/transfer/content_hash.h"
#include "server/library/scan_record.h"

namespace burnish {

namespace fs = std::filesystem;

// Counts up whenever the same wish gives other factors: older files are of no use then.
static constexpr std::string_view kMethod = "levelled seams 1";

static std::string_view bytes_of(std::span<const float> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

uint64_t seams_version(const SeamWish& wish) {
  if (!wish.is_on()) return 0;
  const std::array<double, 1> amount = {wish.amount};
  const bool is_all_free = std::ranges::all_of(wish.free, [](float free) { return free == 1; });
  ContentHash hash;
  hash.update(kMethod);
  hash.update({reinterpret_cast<const char*>(amount.data()), sizeof amount});
  if (!is_all_free) hash.update(bytes_of(wish.free));
  constexpr size_t kDigits = 16;
  const uint64_t version = std::strtoull(hash.finish().substr(0, kDigits).c_str(), nullptr, 16);
  return std::max<uint64_t>(version, 1);
}

namespace {

struct LevelledFile {
  fs::path path;
  fs::file_time_type asked;
};

std::vector<LevelledFile> levelled_files(const fs::path& scan_folder) {
  std::vector<LevelledFile> files;
  std::error_code error;
  fs::directory_iterator entry(scan_folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (!seams_in_sheets_file_name(entry->path().filename().string())) continue;
    std::error_code gone;
    const fs::file_time_type asked = entry->last_write_time(gone);
    if (!gone) files.push_back({entry->path(), asked});
  }
  return files;
}

}  // namespace

// The time of a file's last change says when somebody asked for it: it outlasts a restart.
void keep_levelled_sheets(const fs::path& scan_folder, uint64_t version) {
  std::error_code ignored;
  fs::last_write_time(scan_folder / sheets_file_name(version), fs::file_time_type::clock::now(),
                      ignored);
  std::vector<LevelledFile> files = levelled_files(scan_folder);
  std::ranges::sort(files, std::greater(), &LevelledFile::asked);
  for (size_t i = kLevelledSheetsMax; i < files.size(); ++i) fs::remove(files[i].path, ignored);
}

}  // namespace burnish

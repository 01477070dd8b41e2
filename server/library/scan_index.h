#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/service/scan_info.h"

namespace burnish {

/// The library's scans, read once from their folders. Report each change of a folder here.
/// Thread-safe; its lock is held for lookups only.
class ScanIndex {
 public:
  /// Reads all folders in `scans`. Damaged ones are logged and left out. Fails: as errno says if
  /// the folder or a scan in it cannot be read at all.
  Status read(const std::filesystem::path& scans);

  void put(ScanInfo scan);
  void erase(const std::string& id);

  /// Returns the scans by name, then id.
  std::vector<ScanInfo> list() const;

  std::optional<ScanInfo> find_id(const std::string& id) const;

  /// Returns the scans but `except_id`, by the look_of_name() of their names.
  std::map<std::string, ScanInfo> by_look(const std::string& except_id) const;

  /// Finds a scan by name, id, or the beginning of one id, from kIdBeginDigits digits on. Fails:
  /// not_found; invalid_argument if several scans match.
  Result<ScanInfo> find(const std::string& reference) const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, ScanInfo> by_id_;
};

}  // namespace burnish

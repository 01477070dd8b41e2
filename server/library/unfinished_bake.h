#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "server/memory/quota.h"

namespace burnish {

struct UnfinishedSheets;

/// Keeps what the last cancelled bake of sheets has made, until the server bakes or prepares
/// something else. Thread-safe.
class UnfinishedBake {
 public:
  using Key = std::pair<std::string, uint64_t>;  ///< a scan's id, and a version of its sheets

  UnfinishedBake();
  ~UnfinishedBake();

  /// Returns what was kept of these sheets, else nothing made. Nothing is kept now.
  std::unique_ptr<UnfinishedSheets> take(const Key& key);

  /// Keeps what a bake has made, if there is some, and memory and the folder's disk have room for
  /// as much again.
  void keep(const Key& key, std::unique_ptr<UnfinishedSheets> made, Quota& memory,
            const std::filesystem::path& folder);

  void forget(const std::string& scan_id);
  void forget_others(const std::string& scan_id);

 private:
  std::mutex mutex_;
  Key key_;
  std::unique_ptr<UnfinishedSheets> made_;
  Quota::Share memory_;
};

}  // namespace burnish

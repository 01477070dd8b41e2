#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "server/library/scan_catalogue.h"

namespace burnish {

/// Does what a database does, without one.
struct CatalogueRows {
  std::mutex mutex;
  std::map<std::string, ScanInfo> scans;
  std::string editing;  ///< the session that edits every scan; "": none
  int version = 0;
  std::function<void()> on_placed = [] {};  ///< runs while the scan's row is locked
};

class CatalogueInMemory final : public ScanCatalogue {
 public:
  explicit CatalogueInMemory(CatalogueRows& rows) : rows_(rows) {}

  Result<std::optional<Page>> read(const std::string& mark) override {
    const std::lock_guard lock(rows_.mutex);
    Page page{"version " + std::to_string(rows_.version), {}};
    if (page.mark == mark) return std::optional<Page>();
    for (const auto& [id, scan] : rows_.scans) page.scans.push_back(scan);
    return std::optional<Page>(std::move(page));
  }
  Result<ScanInfo> enter(const ScanInfo& scan, const Files& put) override {
    const std::lock_guard lock(rows_.mutex);
    RETURN_IF_ERROR(put());
    rows_.on_placed();
    ++rows_.version;
    ScanInfo entered = scan;
    entered.prepared.clear();
    return rows_.scans.try_emplace(scan.id, entered).first->second;
  }
  Result<ScanInfo> change(const std::string& id,
                          const std::function<void(ScanInfo&)>& by) override {
    const std::lock_guard lock(rows_.mutex);
    ++rows_.version;
    by(rows_.scans.at(id));
    return rows_.scans.at(id);
  }
  Status remove(const std::string& id, const Files& remove_files) override {
    const std::lock_guard lock(rows_.mutex);
    if (!rows_.editing.empty()) return failed_precondition("session " + rows_.editing);
    RETURN_IF_ERROR(remove_files());
    ++rows_.version;
    rows_.scans.erase(id);
    return Status::ok();
  }

 private:
  CatalogueRows& rows_;
};

}  // namespace burnish

#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/library/scan_catalogue.h"
#include "server/library/scan_names.h"

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
    page.scans = all();
    return std::optional<Page>(std::move(page));
  }
  Result<ScanInfo> enter(const ScanInfo& scan, const Files& put) override {
    const std::lock_guard lock(rows_.mutex);
    if (!rows_.scans.contains(scan.id)) RETURN_IF_ERROR(check_name_is_free(scan, all()));
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
    ScanInfo scan = rows_.scans.at(id);
    by(scan);
    RETURN_IF_ERROR(check_name_is_free(scan, all()));
    ++rows_.version;
    return rows_.scans.at(id) = scan;
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
  std::vector<ScanInfo> all() const {
    std::vector<ScanInfo> scans;
    for (const auto& [id, scan] : rows_.scans) scans.push_back(scan);
    return scans;
  }

  CatalogueRows& rows_;
};

}  // namespace burnish

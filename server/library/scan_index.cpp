#include "server/library/scan_index.h"

#include <algorithm>
#include <tuple>

#include <spdlog/spdlog.h>

#include "server/library/kept_name.h"
#include "server/library/scan_record.h"

namespace burnish {

namespace fs = std::filesystem;

Status ScanIndex::read(const fs::path& scans) {
  std::error_code error;
  fs::directory_iterator entry(scans, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    auto scan = read_scan_folder(entry->path());
    const StatusCode code = scan.status().code();
    if (scan.is_ok()) {
      put(std::move(scan).value());
    } else if (code == StatusCode::kNotFound || code == StatusCode::kDataLoss) {
      spdlog::warn("skipped a scan: {}", scan.status().message());
    } else {
      return scan.status();
    }
  }
  return error ? errno_status("cannot list the scans in " + scans.string(), error.value())
               : Status::ok();
}

void ScanIndex::put(ScanInfo scan) {
  const std::lock_guard lock(mutex_);
  std::string id = scan.id;
  by_id_.insert_or_assign(std::move(id), std::move(scan));
}

void ScanIndex::erase(const std::string& id) {
  const std::lock_guard lock(mutex_);
  by_id_.erase(id);
}

std::vector<ScanInfo> ScanIndex::list() const {
  std::vector<ScanInfo> scans;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, scan] : by_id_) scans.push_back(scan);
  }
  std::sort(scans.begin(), scans.end(), [](const ScanInfo& a, const ScanInfo& b) {
    return std::tie(a.name, a.id) < std::tie(b.name, b.id);
  });
  return scans;
}

std::optional<ScanInfo> ScanIndex::find_id(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return std::nullopt;
  return found->second;
}

std::map<std::string, ScanInfo> ScanIndex::by_look(const std::string& except_id) const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, ScanInfo> looks;
  for (const auto& [id, scan] : by_id_)
    if (id != except_id) looks.try_emplace(look_of_name(scan.name), scan);
  return looks;
}

Result<ScanInfo> ScanIndex::find(const std::string& reference) const {
  const std::lock_guard lock(mutex_);
  if (const auto same = by_id_.find(reference); same != by_id_.end()) return same->second;
  // An old name may be the beginning of another scan's id: neither may win, because anybody can
  // import a scan whose id begins so.
  std::vector<const ScanInfo*> answers;
  for (const auto& [id, scan] : by_id_) {
    const bool begins_so = reference.size() >= kIdBeginDigits && id.starts_with(reference);
    if (scan.name == reference || begins_so) answers.push_back(&scan);
  }
  if (answers.empty()) return not_found("no scan has the name or id '" + reference + "'");
  if (answers.size() > 1)
    return invalid_argument(std::to_string(answers.size()) + " scans match '" + reference +
                            "', among them " + short_id(answers[0]->id) + " and " +
                            short_id(answers[1]->id) + "; name one by its id");
  return *answers[0];
}

}  // namespace burnish

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/service/scan_info.h"

namespace burnish {

/// The scans of a fleet, with their names and units: the same for all servers. The
/// original of each is in the fleet's OriginalStore too. ScanInfo::prepared is empty here.
/// Thread-safe.
class ScanCatalogue {
 public:
  /// All scans at a moment.
  struct Page {
    std::string mark;  ///< changes whenever a scan does
    std::vector<ScanInfo> scans;
  };
  /// Work on the originals, while no other server enters or removes the same scan.
  using Files = std::function<Status()>;

  virtual ~ScanCatalogue() = default;

  /// Returns nothing if the scans are those of `mark`. Fails: unavailable.
  virtual Result<std::optional<Page>> read(const std::string& mark) = 0;

  /// Enters a scan when `put` has put its files in place. Returns it as the catalogue has it: the
  /// first one of an id counts. Fails: already_exists if another scan has a name that looks like
  /// the new one's, or is given one at this moment, before `put` is called; as `put`; unavailable.
  virtual Result<ScanInfo> enter(const ScanInfo& scan, const Files& put) = 0;

  /// Changes the name or the unit. Fails: not_found; already_exists, likewise; unavailable.
  virtual Result<ScanInfo> change(const std::string& id,
                                  const std::function<void(ScanInfo&)>& by) = 0;

  /// Removes a scan, and its files by `remove_files`. Fails: failed_precondition that names a
  /// session of any server that edits it; as `remove_files`; unavailable.
  virtual Status remove(const std::string& id, const Files& remove_files) = 0;
};

}  // namespace burnish

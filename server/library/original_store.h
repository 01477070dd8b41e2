#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/service/scan_info.h"

namespace burnish {

/// A copy of an original in a store. Nobody sees it before it has its place; a copy without a place
/// goes with this object.
class StagedOriginal {
 public:
  virtual ~StagedOriginal() = default;

  /// Gives the scan its place. A scan that is there stays unless its original lacks bytes, or
  /// `replaces` says so. Needs: the store lives; one call. Fails: as the store says.
  virtual Status place(bool replaces) = 0;
};

/// Keeps the originals of a fleet's scans: a folder or a bucket that all its servers reach. A
/// scan appears in it at once and never changes. Each has its info.json beside it, as it was at the
/// import. Messages name no path and no address of it; the log does. Thread-safe.
class OriginalStore {
 public:
  virtual ~OriginalStore() = default;

  /// Copies a scan into the store, unseen. Fails: data_loss if the original is not the scan's;
  /// cancelled; unavailable; as errno says.
  virtual Result<std::unique_ptr<StagedOriginal>> copy_in(const std::filesystem::path& original,
                                                          const ScanInfo& scan,
                                                          const Progress& progress) = 0;

  /// Compares the original with the scan's id. Fails: data_loss if it differs or is missing;
  /// cancelled; unavailable; as errno says.
  virtual Status check(const ScanInfo& scan, const Progress& progress) const = 0;

  /// Copies the original to a new file, and checks it. Fails: likewise.
  virtual Status fetch(const ScanInfo& scan, const std::filesystem::path& to,
                       const Progress& progress) const = 0;

  /// Deletes a scan's files, if there are any.
  virtual Status remove(const std::string& id) = 0;
};

/// Returns a failure without the names of files, which it logs. `store`: "shared folder"; `what`:
/// "fetching".
Status told_apart(const Status& status, const std::string& store, const std::string& what,
                  const ScanInfo& scan);

/// Reports another phase than that of a fetched scan. Needs: `progress` outlives the result.
Progress as_phase(const char* phase, const Progress& progress);

}  // namespace burnish

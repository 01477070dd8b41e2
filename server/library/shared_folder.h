#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/service/scan_info.h"
#include "server/library/staging_folder.h"

namespace burnish {

/// The folder of a fleet's originals, in a file system that all its servers reach. A scan appears
/// in it by one rename and never changes. Files of it are read and written, and never mapped.
/// Messages name no path of it; the log does. Thread-safe.
///
///     scans/ID/        original.EXT, and info.json as it was at the import
///     staging/SERVER/  unfinished files of one server; emptied at its start
class SharedFolder {
 public:
  /// Makes missing folders in an existing folder. `server`: the name of this server in the fleet.
  /// Fails: not_found (a file system that is not mounted); as errno says.
  static Result<std::unique_ptr<SharedFolder>> open(const std::filesystem::path& path,
                                                    const std::string& server);

  /// Copies a scan into staging. Fails: data_loss if the original is not the scan's; cancelled; as
  /// errno says.
  Result<StagingFolder> copy_in(const std::filesystem::path& original, const ScanInfo& scan,
                                const Progress& progress);

  /// Gives a staged scan its place. A scan that is there stays unless its original lacks bytes, or
  /// `replaces` says so. Fails: as errno says.
  Status place(const StagingFolder& staged, const ScanInfo& scan, bool replaces);

  /// Compares the original with the scan's id. Fails: data_loss if it differs or is missing;
  /// cancelled; as errno says.
  Status check(const ScanInfo& scan, const Progress& progress) const;

  /// Copies the original to a new file, and checks it. Fails: likewise.
  Status fetch(const ScanInfo& scan, const std::filesystem::path& to,
               const Progress& progress) const;

  /// Deletes a scan's files, if there are any.
  Status remove(const std::string& id);

 private:
  SharedFolder(std::filesystem::path path, std::filesystem::path staging)
      : path_(std::move(path)), staging_(std::move(staging)) {}

  std::filesystem::path original(const ScanInfo& scan) const;
  bool is_whole(const ScanInfo& scan) const;
  std::filesystem::path staging_path() const;

  const std::filesystem::path path_;
  const std::filesystem::path staging_;
};

/// Renames a folder. NFS may do a rename, lose the answer and try again: the second try finds
/// nothing to rename. So a failed rename is a success if `is_there` says that the target is right.
Status rename_once(const std::filesystem::path& from, const std::filesystem::path& to,
                   const std::function<bool()>& is_there);

}  // namespace burnish

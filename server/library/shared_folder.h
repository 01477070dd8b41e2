#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "server/library/original_store.h"
#include "server/library/staging_folder.h"

namespace burnish {

/// A folder of originals, in a file system that all servers of a fleet reach. A scan appears in it
/// by one rename. Files of it are read and written, and never mapped.
///
///     scans/ID/        original.EXT, and info.json as it was at the import
///     staging/SERVER/  unfinished files of one server; emptied at its start
class SharedFolder final : public OriginalStore {
 public:
  /// Makes missing folders in an existing folder. `server`: the name of this server in the fleet.
  /// Fails: not_found (a file system that is not mounted); as errno says.
  static Result<std::unique_ptr<SharedFolder>> open(const std::filesystem::path& path,
                                                    const std::string& server);

  Result<std::unique_ptr<StagedOriginal>> copy_in(const std::filesystem::path& original,
                                                  const ScanInfo& scan,
                                                  const Progress& progress) override;
  Status check(const ScanInfo& scan, const Progress& progress) const override;
  Status fetch(const ScanInfo& scan, const std::filesystem::path& to,
               const Progress& progress) const override;
  Status remove(const std::string& id) override;

 private:
  class Staged;
  SharedFolder(std::filesystem::path path, std::filesystem::path staging)
      : path_(std::move(path)), staging_(std::move(staging)) {}

  Status place(const StagingFolder& staged, const ScanInfo& scan, bool replaces);
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

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Who may read a file that is written.
enum class FileAccess {
  kAsUsual,   ///< by the user's umask; a replaced file keeps its permissions
  kUserOnly,  ///< 0600, even if others could read the replaced file
};

/// A file that appears whole or not at all, even across a power cut. Bytes go to a temporary file
/// beside the target; commit() syncs it, renames it into place and syncs the folder. Until then,
/// and after any failure, the old file at the path is untouched. A link is followed. Not buffered:
/// hand over large pieces.
class AtomicFile {
 public:
  /// Fails: not_found (no such folder), permission_denied, invalid_argument (the path is a
  /// directory or a device), resource_exhausted.
  static Result<AtomicFile> create(const std::filesystem::path& path,
                                   FileAccess access = FileAccess::kAsUsual);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  /// Removes the temporary file unless commit() succeeded.
  ~AtomicFile();

  /// Appends. Fails: resource_exhausted when the disk or a quota is full.
  Status write(std::span<const uint8_t> bytes);
  Status write(std::string_view text);

  /// Puts the file in its place. Call once, last. After a failure the target is untouched, with one
  /// exception: if the sync of the folder failed, the target is new, but a power cut may restore
  /// the old one.
  Status commit();

 private:
  AtomicFile() = default;
  Status sync_and_close();

  std::filesystem::path path_;
  std::filesystem::path temporary_path_;  // empty once there is nothing to remove
  int fd_ = -1;
};

/// Checks before long work that a file can be written. Fails: as AtomicFile::create().
Status check_writable(const std::filesystem::path& path);

/// Makes the names in a folder survive a power cut. Fails: as errno says.
Status sync_folder(const std::filesystem::path& folder);

/// Writes a small file at once. Fails: as AtomicFile does.
Status write_file(const std::filesystem::path& path, std::string_view text,
                  FileAccess access = FileAccess::kAsUsual);

}  // namespace burnish

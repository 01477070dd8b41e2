#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Who may read a file that is written.
enum class FileAccess {
  kAsUsual,   ///< as the user's umask says; a replaced file keeps its permissions
  kUserOnly,  ///< 0600, also where the replaced file was open to others
};

/// A file that appears whole or not at all, also across a power cut: bytes go to a temporary file
/// beside the target; commit() syncs it, renames it into place and syncs the folder. Until then,
/// and after any failure, what was at the path stays as it was. A link is followed.
/// Not buffered: hand over large pieces.
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

  /// Puts the file in its place. Call once, last. After a failure the target is untouched; only if
  /// the folder's own sync failed it is new, but may go back to the old one in a power cut.
  Status commit();

 private:
  AtomicFile() = default;
  Status sync_and_close();

  std::filesystem::path path_;
  std::filesystem::path temporary_path_;  // empty once there is nothing to remove
  int fd_ = -1;
};

/// Makes the names in a folder outlast a power cut. Fails: as the system says.
Status sync_folder(const std::filesystem::path& folder);

/// All of a small file at once. Fails: as AtomicFile does.
Status write_file(const std::filesystem::path& path, std::string_view text,
                  FileAccess access = FileAccess::kAsUsual);

}  // namespace burnish

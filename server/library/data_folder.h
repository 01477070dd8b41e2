#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// The folder in which a server keeps everything, locked while this object lives.
///
///     lock             held by the running server
///     journal.sqlite   sessions and their edits, unless a database has them
///     paint.sqlite     kept paint, beside such a database
///     scans/ID/        original.EXT, info.json, prepared/, pages-formatN.pages; shared if the scan
///                      is in the catalogue of a fleet
///     staging/         unfinished files; emptied at start
///     spare            room for some starts on a full disk
class DataFolder {
 public:
  /// Makes a missing folder, for its owner alone, takes the lock and empties staging/. Fails:
  /// failed_precondition if another server holds the lock; as errno says.
  static Result<std::unique_ptr<DataFolder>> open(const std::filesystem::path& path);
  ~DataFolder();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path scans() const { return path_ / "scans"; }
  std::filesystem::path journal() const { return journal_in(path_); }
  static std::filesystem::path journal_in(const std::filesystem::path& folder) {
    return folder / "journal.sqlite";
  }
  std::filesystem::path paint() const { return path_ / "paint.sqlite"; }

  /// Returns how many bytes of its disk are free for this user; 0 if nobody knows.
  uint64_t free_bytes() const;

  /// Keeps a little of the disk while there is plenty. Without it a server could not start on a
  /// full disk, and nobody could delete scans.
  void keep_spare() const;
  /// Returns whether the disk has room for a start.
  bool has_room_to_start() const;
  /// Gives a part of that back to the disk, enough for one start. Returns whether there was any.
  bool give_spare() const;

  /// Returns an unused path in staging/ that ends with `suffix`.
  std::filesystem::path staging_path(const std::string& suffix) const;

 private:
  DataFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::filesystem::path spare() const { return path_ / "spare"; }

  std::filesystem::path path_;
  int lock_;
};

/// Returns 16 hexadecimal digits that nobody can guess.
std::string random_name();

}  // namespace burnish

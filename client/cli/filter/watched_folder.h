#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// A mesh file as it lay in a folder. Another content has another time of writing, or is another
/// file of the same name.
struct WatchedFile {
  std::filesystem::path path;
  uint64_t bytes = 0;
  int64_t written_ns = 0;  ///< by the file system's clock
  uint64_t number = 0;     ///< inode: a file that is moved here keeps its time
  bool operator==(const WatchedFile&) const = default;
};

/// The mesh files of a folder, as other programs bring them. Files whose names begin with a dot,
/// and files of other kinds, are not seen. Used from one thread.
class WatchedFolder {
 public:
  /// Fails: as errno says, with the folder's name.
  static Result<std::unique_ptr<WatchedFolder>> open(const std::filesystem::path& folder);
  WatchedFolder(const WatchedFolder&) = delete;
  WatchedFolder& operator=(const WatchedFolder&) = delete;
  ~WatchedFolder();

  /// Returns the files that have not changed for so long, by name: whoever writes them is done.
  /// Fails: as the folder cannot be read.
  Result<std::vector<WatchedFile>> still_files(std::chrono::milliseconds still);

  /// Returns whether the last look saw files that were not still.
  bool has_moving() const { return has_moving_; }

  /// Waits until something changes in the folder, or for so long. A share of another computer tells
  /// of no changes.
  void wait(std::chrono::milliseconds time) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Seen {
    WatchedFile file;
    Clock::time_point since;
  };

  WatchedFolder(std::filesystem::path folder, int events)
      : folder_(std::move(folder)), events_(events) {}

  const std::filesystem::path folder_;
  const int events_;  // of inotify
  std::map<std::filesystem::path, Seen> seen_;
  bool has_moving_ = false;
};

}  // namespace burnish

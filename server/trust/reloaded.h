#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include <sys/stat.h>

#include "common/base/status.h"

namespace burnish {

/// The content of files when they were last read without an error. After a change that cannot be
/// read the old content stays in force, so that a typing error locks nobody out and lets nobody in.
/// Thread-safe.
template <typename T>
class Reloaded {
 public:
  /// Reads for the first time. Fails: as `read` does.
  static Result<std::unique_ptr<Reloaded>> open(std::vector<std::filesystem::path> files,
                                                std::function<Result<T>()> read) {
    std::unique_ptr<Reloaded> reloaded(new Reloaded(std::move(files), std::move(read)));
    RETURN_IF_ERROR(reloaded->refresh(true).status());
    return reloaded;
  }

  std::shared_ptr<const T> get() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }

  /// Reads again if a file has changed since the last try, or in any case. Returns true if there is
  /// a new value. Fails: as `read` does.
  Result<bool> refresh(bool in_any_case) {
    const std::lock_guard reading(reading_);
    const std::vector<Stamp> now = stamps();
    if (now == stamps_ && !in_any_case) return false;
    stamps_ = now;
    ASSIGN_OR_RETURN(T value, read_());
    auto shared = std::make_shared<const T>(std::move(value));
    const std::lock_guard lock(mutex_);
    value_ = std::move(shared);
    return true;
  }

 private:
  /// The part of a file's state that shows that it is another file.
  struct Stamp {
    int64_t inode = 0, bytes = 0, seconds = 0, nanoseconds = 0;
    bool operator==(const Stamp&) const = default;
  };

  Reloaded(std::vector<std::filesystem::path> files, std::function<Result<T>()> read)
      : files_(std::move(files)), read_(std::move(read)) {}

  std::vector<Stamp> stamps() const {
    std::vector<Stamp> all;
    for (const auto& file : files_) {
      struct stat s = {};
      if (stat(file.c_str(), &s) != 0) s = {};
      all.push_back(
          {static_cast<int64_t>(s.st_ino), s.st_size, s.st_mtim.tv_sec, s.st_mtim.tv_nsec});
    }
    return all;
  }

  const std::vector<std::filesystem::path> files_;
  const std::function<Result<T>()> read_;
  std::mutex reading_;  // guards stamps_
  std::vector<Stamp> stamps_;
  mutable std::mutex mutex_;  // guards value_
  std::shared_ptr<const T> value_;
};

}  // namespace burnish

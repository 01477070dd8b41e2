#pragma once

#include <filesystem>
#include <utility>

#include "common/base/status.h"

namespace burnish {

/// A path in a staging folder. What is there is deleted with this object unless it was moved.
class StagingFolder {
 public:
  explicit StagingFolder(std::filesystem::path path) : path_(std::move(path)) {}
  StagingFolder(StagingFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  StagingFolder& operator=(StagingFolder&&) = delete;
  ~StagingFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }

  /// Makes a folder of this name within it, and itself, for the owner alone. Fails: as errno says.
  Status make(const std::string& name = {}) const {
    std::error_code error;
    std::filesystem::create_directories(path_ / name, error);
    if (!error) std::filesystem::permissions(path_, std::filesystem::perms::owner_all, error);
    if (!error) return Status::ok();
    return errno_status("cannot make the folder " + (path_ / name).string(), error.value());
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace burnish

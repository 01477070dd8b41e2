#pragma once

#include <filesystem>
#include <functional>

#include "common/base/status.h"

namespace burnish {

/// A folder that appears whole or not at all. Its files are written beside the target, in a hidden
/// folder, until commit() puts it in its place.
class NewFolder {
 public:
  /// Returns why a folder may not be replaced; empty: it may.
  using Guard = std::function<std::string(const std::filesystem::path&)>;

  /// A target that is an empty folder is always replaced, another one if `may_replace` has no
  /// objection. Fails: already_exists (the objection), as errno says.
  static Result<NewFolder> create(const std::filesystem::path& target, const Guard& may_replace);

  NewFolder(NewFolder&& other) noexcept;
  /// Removes what was written, unless commit() has succeeded.
  ~NewFolder();

  const std::filesystem::path& path() const { return path_; }  ///< where to write

  /// Puts the folder in its place. Call once, last. Fails: as errno says; the old folder is left.
  Status commit();

 private:
  NewFolder(std::filesystem::path target, std::filesystem::path path);

  std::filesystem::path target_;
  std::filesystem::path path_;  // empty once there is nothing to remove
};

}  // namespace burnish
